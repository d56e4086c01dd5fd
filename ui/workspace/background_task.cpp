#include "ui/workspace/background_task.hpp"

#include <atomic>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string_view>
#include <thread>
#include <utility>

namespace forefront {

class BackgroundTask::Worker {
  public:
    Worker(std::string name, Work work, std::function<void()> wake)
        : wake_(std::move(wake)), name_(std::move(name)),
          thread_([this, task = std::move(work)](const std::stop_token &stop) {
              run(task, stop);
              ended_ = true;
          }) {}

    void stop() { thread_.request_stop(); }
    /// Returns true once the destructor no longer has to wait.
    bool ended() const { return ended_; }
    std::size_t reports() const { return reports_; }
    std::string name() const {
        const std::lock_guard lock(mutex_);
        return name_;
    }
    double fraction() const { return fraction_; }
    /// Returns the result; none until it is there.
    std::optional<Finish> result() const {
        const std::lock_guard lock(mutex_);
        return result_;
    }

  private:
    void run(const Work &work, const std::stop_token &stop) {
        Progress progress;
        progress.stop = stop;
        progress.report = [this](std::string_view stage, double fraction) {
            constexpr double kStep = 0.02; // a frame for each report would cost more than the work
            {
                const std::lock_guard lock(mutex_);
                if (name_ == stage && fraction < fraction_ + kStep) {
                    return;
                }
                name_ = stage;
            }
            fraction_ = fraction;
            ++reports_;
            wake_();
        };
        Finish result = work(progress);
        {
            const std::lock_guard lock(mutex_);
            result_ = std::move(result);
        }
        ++reports_;
        wake_();
    }

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::string name_;             ///< guarded by the mutex
    std::optional<Finish> result_; ///< guarded by the mutex
    std::atomic<double> fraction_ = 0.0;
    std::atomic<std::size_t> reports_ = 0;
    std::atomic<bool> ended_ = false;
    std::jthread thread_; ///< last, so that it ends before what it uses
};

BackgroundTask::BackgroundTask(std::function<void()> wake) : wake_(std::move(wake)) {}

BackgroundTask::~BackgroundTask() = default;

void BackgroundTask::start(std::string name, Work work) {
    cancel();
    name_ = name;
    fraction_ = 0.0;
    seen_ = 0;
    worker_ = std::make_unique<Worker>(std::move(name), std::move(work), wake_);
}

void BackgroundTask::cancel() {
    if (worker_) {
        worker_->stop();
        retired_.push_back(std::move(worker_));
    }
    ready_ = false;
}

bool BackgroundTask::hasNews() const {
    return worker_ && worker_->reports() != seen_;
}

bool BackgroundTask::refresh() {
    std::erase_if(retired_, [](const std::unique_ptr<Worker> &worker) { return worker->ended(); });
    if (!hasNews()) {
        return false;
    }
    seen_ = worker_->reports(); // before what they report, which may be newer
    name_ = worker_->name();
    fraction_ = worker_->fraction();
    ready_ = worker_->result().has_value();
    return true;
}

void BackgroundTask::finish() {
    const std::optional<Finish> result = worker_->result();
    cancel(); // the result may start another task
    if (*result) {
        (*result)();
    }
}

} // namespace forefront
