#pragma once

#include "ui/workspace/background/leavable_thread.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace forefront {

/// A state that a thread changes and another one reads. The thread shares it, since its reader may leave it behind.
template <class State>
class WorkerState {
  public:
    /// `wake` is called from the thread after each change, until close().
    WorkerState(State initial, std::function<void()> wake) : wake_(std::move(wake)), state_(std::move(initial)) {}

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
        const std::lock_guard lock(wakeMutex_);
        if (wake_) {
            wake_();
        }
    }
    /// Never calls `wake` again; what it uses may be gone.
    void close() {
        const std::lock_guard lock(wakeMutex_);
        wake_ = {};
    }

  private:
    std::mutex wakeMutex_;
    std::function<void()> wake_; ///< guarded by wakeMutex_
    mutable std::mutex mutex_;
    State state_; ///< guarded by mutex_
    std::atomic<std::uint64_t> version_ = 0;
};

/// A thread with its state. The thread ends with the function that it runs.
template <class State>
class StateWorker {
  public:
    using Run = std::function<void(WorkerState<State> &, const std::stop_token &)>;

    /// `patience`: how long the destructor waits for the thread; see LeavableThread.
    StateWorker(State initial, std::function<void()> wake, Run run, std::chrono::milliseconds patience)
        : shared_(std::make_shared<WorkerState<State>>(std::move(initial), std::move(wake))),
          thread_([shared = shared_, work = std::move(run)](const std::stop_token &stop) { work(*shared, stop); },
                  patience) {}
    ~StateWorker() { shared_->close(); }
    StateWorker(const StateWorker &) = delete;
    StateWorker &operator=(const StateWorker &) = delete;

    void stop() { thread_.requestStop(); }
    /// Returns true once the destructor no longer has to wait.
    bool ended() const { return thread_.ended(); }
    std::uint64_t version() const { return shared_->version(); }
    State state() const { return shared_->state(); }

  private:
    std::shared_ptr<WorkerState<State>> shared_;
    LeavableThread thread_;
};

/// The worker whose state is awaited, and earlier ones that were told to stop and end by themselves, since joining
/// their threads could take a while. Call all members from one thread; only the destructor waits.
template <class State>
class RetiringWorker {
  public:
    /// `patience`: how long the destructor waits for each thread; see LeavableThread.
    explicit RetiringWorker(std::chrono::milliseconds patience) : patience_(patience) {}
    /// Stops the worker, if there is one, and starts another.
    void start(State initial, std::function<void()> wake, typename StateWorker<State>::Run run) {
        retire();
        worker_ = std::make_unique<StateWorker<State>>(std::move(initial), std::move(wake), std::move(run), patience_);
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
    std::chrono::milliseconds patience_;
    std::unique_ptr<StateWorker<State>> worker_; ///< null: none
    std::vector<std::unique_ptr<StateWorker<State>>> retired_;
    std::uint64_t seen_ = 0; ///< version of the state fetched last
};

} // namespace forefront
