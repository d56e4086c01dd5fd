#pragma once

#include "core/engine/base/progress.hpp"

#include <cstddef>

namespace forefront {

/// Reports progress of a loop and lets it be cancelled. Checks the stop token once every kItems items, which should
/// take a few milliseconds.
class PacedProgress {
  public:
    /// `stage` must outlive this object; `items` is the expected number of calls to next().
    PacedProgress(const Progress &progress, std::string_view stage, std::size_t items)
        : progress_(progress), stage_(stage), items_(items) {}

    /// Call before each item. Returns false once cancelled.
    bool next() { return done_++ % kItems != 0 || check(); }

    static constexpr std::size_t kItems = 4096;

  private:
    bool check() {
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
