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

/// A pool of threads that execute numbered tasks together with the caller. Any thread may take any task, so results
/// that must not depend on the number of threads may depend only on the number of the task. One caller at a time.
class ThreadPool {
  public:
    /// `threads` includes the caller: 0 and 1 start none. If the system refuses some, the others do the work.
    explicit ThreadPool(unsigned threads);
    ~ThreadPool();
    ThreadPool(const ThreadPool &) = delete;
    ThreadPool &operator=(const ThreadPool &) = delete;

    /// Returns the number of working threads, including the caller: at least 1.
    unsigned threads() const { return static_cast<unsigned>(workers_.size()) + 1U; }

    using Task = std::function<void(std::size_t task, unsigned thread)>;
    /// Calls work(task, thread) for each task below `tasks`, thread below threads(), and returns when all are done.
    /// An exception thrown by a task is rethrown here once all running tasks have ended. After an exception or a stop
    /// request no further task begins.
    void run(std::size_t tasks, const Task &work, const std::stop_token &stop = {});

    /// Calls work(begin, end, chunk) for consecutive ranges of `size` that cover [0, count); after a stop request no
    /// further range begins.
    template <class Work>
    void forChunks(std::size_t count, std::size_t size, const Work &work, const std::stop_token &stop = {}) {
        run((count + size - 1) / size,
            [&](std::size_t chunk, unsigned) { work(chunk * size, std::min(count, (chunk + 1) * size), chunk); }, stop);
    }

    /// Returns the CPU time used so far by the threads other than the caller, in seconds.
    double workerSeconds();

  private:
    void serve(const std::stop_token &stop, unsigned thread);
    void takeTasks(std::unique_lock<std::mutex> &lock, unsigned thread);

    std::mutex mutex_;
    std::condition_variable_any begin_;
    std::condition_variable done_;
    // The mutex guards all members below.
    const Task *work_ = nullptr;
    const std::stop_token *stop_ = nullptr;
    std::size_t next_ = 0, tasks_ = 0;
    std::size_t active_ = 0; ///< tasks that are running
    std::exception_ptr failure_;
    std::vector<std::jthread> workers_; ///< last, so that they are joined before the members they use are destroyed
};

} // namespace forefront
