#pragma once

#include "core/base/diagnostic.hpp"

#include <atomic>
#include <csignal>
#include <stop_token>
#include <thread>

namespace forefront {

/// What SIGINT and SIGTERM do while it lives: they end the program at once with kCancelled as long as it only reads,
/// which leaves nothing behind and may wait forever on a pipe; afterwards they ask for a stop. Make it before other
/// threads, which inherit its signal mask.
class InterruptWatch {
  public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch &) = delete;
    InterruptWatch &operator=(const InterruptWatch &) = delete;

    /// From now on there may be something to clean up.
    void askFromNowOn() { asks_ = true; }
    std::stop_token token() const { return cancel_.get_token(); }
    bool interrupted() const { return cancel_.stop_requested(); }

  private:
    sigset_t before_{};
    std::stop_source cancel_;
    std::atomic<bool> asks_ = false;
    std::jthread watcher_;
};

/// Says on stderr why the command ends, "cancelled" or the faults, and returns the exit code.
int refuse(const Diagnostics &faults, const InterruptWatch &interrupt);

} // namespace forefront
