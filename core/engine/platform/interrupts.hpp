#pragma once

#include <chrono>

#ifndef _WIN32
#include <csignal>
#endif

namespace forefront {

/// Turns requests to end the program (Ctrl-C, the signals SIGINT and SIGTERM) into events that a thread waits for. One
/// object at a time; threads that are started while it lives do not take the signals either.
class InterruptEvents {
  public:
    InterruptEvents();
    ~InterruptEvents();
    InterruptEvents(const InterruptEvents &) = delete;
    InterruptEvents &operator=(const InterruptEvents &) = delete;

    /// Waits up to `time` for a request. Returns true if there was one.
    bool wait(std::chrono::milliseconds time);

#ifndef _WIN32
  private:
    sigset_t signals_{}, before_{};
#endif
};

} // namespace forefront
