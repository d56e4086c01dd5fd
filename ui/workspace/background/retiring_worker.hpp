#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

namespace forefront {

/// A state that a thread changes and another one reads. The thread ends with the function that it runs.
template <class State>
class StateWorker {
  public:
    using Run = std::function<void(StateWorker &, const std::stop_token &)>;

    /// `wake` is called from the thread after each change.
    StateWorker(State initial, std::function<void()> wake, Run run)
        : wake_(std::move(wake)), state_(std::move(initial)),
          thread_([this, work = std::move(run)](const std::stop_token &stop) {
              work(*this, stop);
              ended_ = true;
          }) {}

    void stop() { thread_.request_stop(); }
    /// Returns true once the destructor no longer has to wait.
    bool ended() const { return ended_; }
    /// Returns the number of changes so far.
    std::uint64_t version() const { return version_; }
    State state() const {
        const std::lock_guard lock(mutex_);
        return state_;
    }
    /// Changes the state; for the thread. `apply` returns false to leave it as it is.
    template <class Apply>
    void change(Apply apply) {
        {
            const std::lock_guard lock(mutex_);
            if (!apply(state_)) {
                return;
            }
            ++version_;
        }
        wake_();
    }

  private:
    std::function<void()> wake_;
    mutable std::mutex mutex_;
    State state_; ///< guarded by the mutex
    std::atomic<std::uint64_t> version_ = 0;
    std::atomic<bool> ended_ = false;
    std::jthread thread_; ///< last, so that it ends before what it uses
};

/// The worker whose state is awaited, and earlier ones that were told to stop and end by themselves, since joining
/// their threads could take a while. Call all members from one thread; only the destructor waits.
template <class State>
class RetiringWorker {
  public:
    /// Stops the worker, if there is one, and starts another.
    void start(State initial, std::function<void()> wake, typename StateWorker<State>::Run run) {
        retire();
        worker_ = std::make_unique<StateWorker<State>>(std::move(initial), std::move(wake), std::move(run));
    }
    /// Stops the worker, which may still report.
    void stop() {
        if (worker_) {
            worker_->stop();
        }
    }
    /// Stops the worker and drops its state; its memory is freed by a later refresh().
    void retire() {
        stop();
        if (worker_) {
            retired_.push_back(std::move(worker_));
        }
        seen_ = 0;
    }
    bool working() const { return worker_ != nullptr; }
    bool hasNews() const { return worker_ && worker_->version() != seen_; }
    /// Returns the newest state if it has changed since the last call.
    std::optional<State> refresh() {
        std::erase_if(retired_, [](const std::unique_ptr<StateWorker<State>> &worker) { return worker->ended(); });
        if (!hasNews()) {
            return std::nullopt;
        }
        seen_ = worker_->version(); // before the state, which may be newer
        return worker_->state();
    }

  private:
    std::unique_ptr<StateWorker<State>> worker_; ///< null: none
    std::vector<std::unique_ptr<StateWorker<State>>> retired_;
    std::uint64_t seen_ = 0; ///< version of the state fetched last
};

} // namespace forefront
