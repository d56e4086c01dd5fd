#pragma once

#include "core/base/diagnostic.hpp"

#include <cstdint>
#include <deque>

namespace forefront {

/// What the program has to say, newest last. Entries with a place can be gone to.
class MessageLog {
  public:
    struct Entry {
        Diagnostic diagnostic;
        double time = 0.0;        ///< Platform::now() when it was added
        std::uint64_t number = 0; ///< counts up from 1
    };
    static constexpr std::size_t kLimit = 1000;

    void add(Diagnostic diagnostic) {
        entries_.push_back({std::move(diagnostic), time_, ++count_});
        if (entries_.size() > kLimit) {
            entries_.pop_front();
        }
    }
    void add(const Diagnostics &diagnostics) {
        for (const Diagnostic &diagnostic : diagnostics) {
            add(diagnostic);
        }
    }
    void note(std::string message) { add(Diagnostic{.severity = Severity::Note, .message = std::move(message)}); }
    void clear() { entries_.clear(); }
    const std::deque<Entry> &entries() const { return entries_; }
    void setTime(double now) { time_ = now; }

  private:
    std::deque<Entry> entries_;
    std::uint64_t count_ = 0;
    double time_ = 0.0;
};

} // namespace forefront
