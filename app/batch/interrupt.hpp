#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/platform/interrupts.hpp"

#include <atomic>
#include <stop_token>
#include <thread>

namespace forefront {

/// Handles SIGINT and SIGTERM during its lifetime. While the program only reads its input, a signal ends it at once
/// with kCancelled: there is nothing to clean up yet, and reading from a pipe may block forever. After deferToStop(), a
/// signal requests a stop. Create it before all other threads, so that they inherit its signal mask.
class InterruptWatch {
  public:
    InterruptWatch();
    ~InterruptWatch() = default;
    InterruptWatch(const InterruptWatch &) = delete;
    InterruptWatch &operator=(const InterruptWatch &) = delete;

    /// Makes signals request a stop from now on, since there may be something to clean up.
    void deferToStop() { defers_ = true; }
    std::stop_token token() const { return cancel_.get_token(); }
    bool interrupted() const { return cancel_.stop_requested(); }

  private:
    InterruptEvents events_;
    std::stop_source cancel_;
    std::atomic<bool> defers_ = false;
    std::jthread watcher_; ///< last: it uses all of the above
};

/// Prints to stderr why the command failed ("cancelled" or the faults) and returns the exit code.
int refuse(const Diagnostics &faults, const InterruptWatch &interrupt);

} // namespace forefront
