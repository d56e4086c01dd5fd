#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace forefront {

/// A few threads that work off numbered tasks together with the caller. Which thread takes which task is open, so a
/// result that shall not depend on the number of threads may depend on the task's number only. One caller at a time.
class ThreadPool {
  public:
    /// `threads` counts the caller: 0 and 1 start none. Where the system refuses more, those that it gave do the work.
    explicit ThreadPool(unsigned threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool &) = delete;
    ThreadPool &operator=(const ThreadPool &) = delete;

    /// Threads that work, the caller included: at least 1.
    unsigned threads() const { return static_cast<unsigned>(workers_.size()) + 1U; }

    using Task = std::function<void(std::size_t task, unsigned thread)>;
    /// Calls work(task, thread) for each task below `tasks`, thread below threads(), and returns when all are done.
    /// What a task throws is thrown here, once all have ended; tasks not yet begun are then left out, and so they are
    /// after a stop.
    void run(std::size_t tasks, const Task &work, const std::stop_token &stop = {});

    /// Calls work(begin, end, chunk) for consecutive ranges of `size` that cover [0, count), but for those that a stop
    /// leaves out.
    template <class Work>
    void forChunks(std::size_t count, std::size_t size, const Work &work, const std::stop_token &stop = {}) {
        run((count + size - 1) / size,
            [&](std::size_t chunk, unsigned) { work(chunk * size, std::min(count, (chunk + 1) * size), chunk); }, stop);
    }

    /// CPU time that the threads beside the caller have taken so far, in seconds.
    double workerSeconds();

  private:
    void serve(const std::stop_token &stop, unsigned thread);
    void takeTasks(std::unique_lock<std::mutex> &lock, unsigned thread);

    std::mutex mutex_;
    std::condition_variable_any begin_;
    std::condition_variable done_;
    // All below is guarded by the mutex.
    const Task *work_ = nullptr;
    const std::stop_token *stop_ = nullptr;
    std::size_t next_ = 0, tasks_ = 0;
    std::size_t active_ = 0; ///< tasks begun and not ended
    std::exception_ptr failure_;
    std::vector<std::jthread> workers_; ///< last, so that they end before what they use
};

} // namespace forefront
