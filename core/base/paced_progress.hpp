#pragma once

#include "core/base/progress.hpp"

#include <cstddef>

namespace forefront {

/// A loop that reports and can be cancelled: looks at the stop token every some thousand items, which should take a few
/// milliseconds.
class PacedProgress {
  public:
    /// The stage is not copied. Reports the part done of `items`.
    PacedProgress(const Progress &progress, std::string_view stage, std::size_t items)
        : progress_(progress), stage_(stage), items_(items) {}

    /// To be asked before each item; false when cancelled.
    bool next() { return done_++ % kItems != 0 || look(); }

    static constexpr std::size_t kItems = 4096;

  private:
    bool look() {
        if (progress_.cancelled()) {
            return false;
        }
        const auto done = static_cast<double>(done_ - 1), all = static_cast<double>(items_);
        progress_(stage_, done < all ? done / all : 1.0);
        return true;
    }

    const Progress &progress_;
    std::string_view stage_;
    std::size_t items_;
    std::size_t done_ = 0;
};

} // namespace forefront
