#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace forefront {

/// Runs a function on another thread. Throws std::system_error if no thread can be started.
using ThreadStarter = std::function<std::thread(std::function<void()>)>;

/// Starts a std::thread.
inline std::thread startThread(std::function<void()> run) {
    return std::thread(std::move(run));
}

/// A thread that may hang in a call of the operating system, such as reading a file of a server that no longer answers.
/// The destructor asks it to stop, waits for a moment, and then leaves it behind: the thread must own or share
/// everything that it uses, and must use nothing that its owner may have destroyed once it was asked to stop.
class LeavableThread {
  public:
    using Run = std::function<void(const std::stop_token &)>;
    /// The destructor waits until the thread ends.
    static constexpr std::chrono::milliseconds kForever = std::chrono::milliseconds::max();
    /// The time that the threads that read files get to end.
    static constexpr std::chrono::milliseconds kPatience{1000};

    /// `patience`: how long the destructor waits. `start`: replaced by tests.
    LeavableThread(Run run, std::chrono::milliseconds patience, const ThreadStarter &start = startThread)
        : patience_(patience), end_(std::make_shared<End>()),
          thread_(start([work = std::move(run), end = end_, stop = stop_.get_token()] {
              work(stop);
              const std::lock_guard lock(end->mutex);
              end->reached = true;
              end->changed.notify_all();
          })) {}
    ~LeavableThread() {
        stop_.request_stop();
        const bool joins = patience_ == kForever || endsWithin(patience_);
        joins ? thread_.join() : thread_.detach();
    }
    LeavableThread(const LeavableThread &) = delete;
    LeavableThread &operator=(const LeavableThread &) = delete;

    void requestStop() { stop_.request_stop(); }
    /// Returns true once the destructor no longer has to wait.
    bool ended() const {
        const std::lock_guard lock(end_->mutex);
        return end_->reached;
    }

  private:
    struct End {
        std::mutex mutex;
        std::condition_variable changed;
        bool reached = false; ///< guarded by the mutex
    };

    bool endsWithin(std::chrono::milliseconds time) {
        std::unique_lock lock(end_->mutex);
        return end_->changed.wait_for(lock, time, [this] { return end_->reached; });
    }

    std::chrono::milliseconds patience_;
    std::stop_source stop_;
    std::shared_ptr<End> end_;
    std::thread thread_;
};

} // namespace forefront
