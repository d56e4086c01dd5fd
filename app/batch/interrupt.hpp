#pragma once

#include <csignal>
#include <stop_token>
#include <thread>

namespace forefront {

/// While it lives, SIGINT and SIGTERM ask for a stop instead of ending the program. Make it before other threads, which
/// inherit its signal mask.
class InterruptWatch {
  public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch &) = delete;
    InterruptWatch &operator=(const InterruptWatch &) = delete;

    std::stop_token token() const { return cancel_.get_token(); }
    bool interrupted() const { return cancel_.stop_requested(); }

  private:
    sigset_t before_{};
    std::stop_source cancel_;
    std::jthread watcher_;
};

} // namespace forefront
