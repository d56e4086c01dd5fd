#pragma once

#include "ui/background/background_list.hpp"
#include "ui/background/leavable_thread.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

namespace forefront {

/// The state shared by a worker and its thread, since a thread may outlive its worker.
template <class Request, class Answer>
class LatestMailbox {
  public:
    /// `wake` is called after each answer, until close().
    LatestMailbox(Answer first, std::function<void()> wake) : wake_(std::move(wake)), answer_(std::move(first)) {}

    /// Leaves a request for the thread. Returns the request if no thread is at work: it takes one to answer it.
    std::optional<Request> submit(Request request) {
        const std::lock_guard lock(mutex_);
        if (running_) {
            pending_ = std::move(request);
            return std::nullopt;
        }
        running_ = true;
        stop_ = std::stop_source();
        return request;
    }
    /// Stops the work on the current request, and drops the one that waits.
    void requestStop() {
        const std::lock_guard lock(mutex_);
        pending_.reset();
        stop_.request_stop();
    }
    /// Also drops later answers and never calls `wake` again, so that the objects it uses may be destroyed.
    void close() {
        requestStop();
        {
            const std::lock_guard lock(mutex_);
            closed_ = true;
        }
        const std::lock_guard lock(wakeMutex_);
        wake_ = {};
    }
    bool running() const {
        const std::lock_guard lock(mutex_);
        return running_;
    }
    /// Returns the number of answers so far.
    std::uint64_t version() const {
        const std::lock_guard lock(mutex_);
        return version_;
    }
    std::pair<Answer, std::uint64_t> newest() const {
        const std::lock_guard lock(mutex_);
        return {answer_, version_};
    }
    void waitUntilIdle() {
        std::unique_lock lock(mutex_);
        idle_.wait(lock, [this] { return !running_; });
    }

    std::stop_token stop() const {
        const std::lock_guard lock(mutex_);
        return stop_.get_token();
    }
    /// Publishes an answer; for the thread.
    void publish(Answer answer) {
        {
            const std::lock_guard lock(mutex_);
            if (closed_) {
                return;
            }
            std::swap(answer_, answer); // the earlier one is freed outside the lock
            ++version_;
        }
        wakeWindow();
    }
    /// Publishes the last answer to a request and returns the next request, if one waits; for the thread.
    std::optional<Request> finish(Answer answer) {
        std::optional<Request> next;
        {
            const std::lock_guard lock(mutex_);
            if (!closed_) {
                std::swap(answer_, answer);
                ++version_;
                next = std::exchange(pending_, std::nullopt);
                stop_ = std::stop_source();
            }
            running_ = next.has_value();
            idle_.notify_all();
        }
        wakeWindow();
        return next;
    }

  private:
    void wakeWindow() {
        const std::lock_guard lock(wakeMutex_);
        if (wake_) {
            wake_();
        }
    }

    std::mutex wakeMutex_;
    std::function<void()> wake_; ///< guarded by wakeMutex_
    mutable std::mutex mutex_;   ///< guards all that follows
    std::condition_variable idle_;
    std::optional<Request> pending_; ///< waits until the current request is answered
    std::stop_source stop_;          ///< of the current request
    Answer answer_;
    std::uint64_t version_ = 0;
    bool running_ = false; ///< a thread is at work, or about to start
    bool closed_ = false;
};

/// A request that a thread answers.
template <class Request, class Answer>
struct LatestTurn {
    const Request &request;
    const Answer &earlier; ///< the answer before this one
    std::stop_token stop;
    LatestMailbox<Request, Answer> &mailbox;

    /// Shows an answer that is not the last one to this request.
    void publish(Answer answer) const { mailbox.publish(std::move(answer)); }
};

/// Answers requests on a separate thread. The newest request counts: one that waits is replaced by a newer one, while
/// the one under way is finished and its answer shown, so that the picture keeps moving when requests come faster than
/// answers. Call all members from one thread; none of them waits, except wait() and the destructor. If no thread can
/// be started, submit() answers the request itself.
template <class Request, class Answer>
class Latest final : public BackgroundActivity {
  public:
    using Turn = LatestTurn<Request, Answer>;
    /// Returns the last answer to a request. Runs on the thread and may use only what it owns or shares: with a limited
    /// patience, the thread may outlive the worker.
    using Work = std::function<Answer(const Turn &)>;

    /// `first`: the answer before any request. `patience`: how long the destructor waits for the thread, see
    /// LeavableThread.
    Latest(BackgroundList &list, Work work, Answer first = {}, std::chrono::milliseconds patience = kForever,
           NewsPace pace = NewsPace::AtOnce, ThreadStarter start = startThread)
        : BackgroundActivity(list, pace), work_(std::move(work)), start_(std::move(start)), patience_(patience),
          now_(std::move(first)), mailbox_(std::make_shared<Mailbox>(now_, list.wake())) {}
    ~Latest() override { mailbox_->close(); }

    static constexpr std::chrono::milliseconds kForever = LeavableThread::kForever;

    /// Requests an answer.
    void submit(Request request) {
        std::optional<Request> first = mailbox_->submit(std::move(request));
        if (!first) {
            return;
        }
        leaveThread();
        // A thread can only be given what can be copied.
        const auto shared = std::make_shared<Request>(*std::move(first));
        const auto answer = [work = work_, mailbox = mailbox_, shared] {
            for (std::optional<Request> next(std::move(*shared)); next;) {
                const Answer earlier = mailbox->newest().first;
                next = mailbox->finish(work(Turn{*next, earlier, mailbox->stop(), *mailbox}));
            }
        };
        try {
            thread_ =
                std::make_unique<LeavableThread>([answer](const std::stop_token &) { answer(); }, patience_, start_);
        } catch (const std::system_error &) { // a pause is better than no answer
            answer();
        }
    }
    /// Stops the work under way, whose answer still counts.
    void requestStop() { mailbox_->requestStop(); }
    /// Drops the requests and all answers that have not been fetched. The work under way is stopped; its thread ends by
    /// itself, and its memory is freed by a later refresh().
    void cancel() {
        mailbox_->close();
        leaveThread();
        mailbox_ = std::make_shared<Mailbox>(now_, list().wake());
        seen_ = 0;
    }
    /// Does the same, and replaces the answer fetched last.
    void clear(Answer first = {}) {
        now_ = std::move(first);
        cancel();
    }
    bool working() const override { return mailbox_->running(); }
    bool hasNews() const override { return mailbox_->version() != seen_; }
    /// Fetches the newest answer. Returns true if it is new.
    bool refresh() {
        freeEnded();
        if (!hasNews()) {
            return false;
        }
        std::tie(now_, seen_) = mailbox_->newest();
        return true;
    }
    /// Returns the answer fetched last.
    const Answer &now() const { return now_; }
    /// Waits until the requests are answered.
    void wait() { mailbox_->waitUntilIdle(); }

  private:
    using Mailbox = LatestMailbox<Request, Answer>;

    void freeEnded() {
        std::erase_if(left_, [](const std::unique_ptr<LeavableThread> &thread) { return thread->ended(); });
    }
    void leaveThread() {
        freeEnded();
        if (thread_) {
            left_.push_back(std::move(thread_));
        }
    }

    Work work_;
    ThreadStarter start_;
    std::chrono::milliseconds patience_;
    Answer now_;
    std::uint64_t seen_ = 0; ///< version of `now_`
    std::shared_ptr<Mailbox> mailbox_;
    std::vector<std::unique_ptr<LeavableThread>> left_; ///< that end by themselves; joining them could take a while
    std::unique_ptr<LeavableThread> thread_;            ///< null: none was needed yet
};

} // namespace forefront
