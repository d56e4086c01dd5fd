#include "core/engine/base/thread_pool.hpp"

#include "core/engine/platform/thread_clock.hpp"

#include <system_error>
#include <utility>

namespace forefront {

ThreadPool::ThreadPool(unsigned threads) {
    try {
        for (unsigned thread = 1; thread < threads; ++thread) {
            workers_.emplace_back([this, thread](const std::stop_token &stop) { serve(stop, thread); });
        }
    } catch (const std::system_error &) { // the system refuses further threads
    }
}

ThreadPool::~ThreadPool() = default;

void ThreadPool::run(std::size_t tasks, const Task &work, const std::stop_token &stop) {
    if (workers_.empty() || tasks <= 1) {
        for (std::size_t task = 0; task < tasks && !stop.stop_requested(); ++task) {
            work(task, 0);
        }
        return;
    }
    std::unique_lock lock(mutex_);
    work_ = &work;
    stop_ = &stop;
    next_ = 0;
    tasks_ = tasks;
    begin_.notify_all();
    takeTasks(lock, 0);
    done_.wait(lock, [this] { return active_ == 0; });
    work_ = nullptr;
    tasks_ = 0;
    if (failure_) {
        std::rethrow_exception(std::exchange(failure_, nullptr));
    }
}

double ThreadPool::workerSeconds() {
    double seconds = 0.0;
    for (std::jthread &worker : workers_) {
        seconds += cpuSecondsOf(worker);
    }
    return seconds;
}

void ThreadPool::serve(const std::stop_token &stop, unsigned thread) {
    std::unique_lock lock(mutex_);
    while (begin_.wait(lock, stop, [this] { return next_ < tasks_; })) {
        takeTasks(lock, thread);
    }
}

void ThreadPool::takeTasks(std::unique_lock<std::mutex> &lock, unsigned thread) {
    while (next_ < tasks_) {
        if (stop_->stop_requested()) {
            next_ = tasks_;
            break;
        }
        const std::size_t task = next_++;
        ++active_;
        lock.unlock();
        std::exception_ptr failure;
        try {
            (*work_)(task, thread);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        if (failure) {
            failure_ = failure;
            next_ = tasks_;
        }
        if (--active_ == 0 && next_ >= tasks_) {
            done_.notify_one();
        }
    }
}

} // namespace forefront
