#pragma once

#include "core/base/progress.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

/// A long task of the window on a separate thread, such as reading a file. At most one result is awaited: another start
/// cancels the earlier task. Call all members from one thread; none of them waits, except the destructor.
class BackgroundTask {
  public:
    /// Uses the result, on the thread that calls finish(); empty: nothing to do.
    using Finish = std::function<void()>;
    using Work = std::function<Finish(const Progress &)>;

    /// `wake` is called from the thread of the task when there is news.
    explicit BackgroundTask(std::function<void()> wake);
    ~BackgroundTask();

    /// Starts a task; `name` says what it does, such as "reading plate.msh".
    void start(std::string name, Work work);
    /// Drops the task and its result. Its thread ends by itself, at the next point where it looks; its memory is freed
    /// by a later refresh().
    void cancel();
    /// Fetches the newest progress. Called once per frame; returns true if it has changed.
    bool refresh();
    bool hasNews() const;
    /// Returns true until the result has been used.
    bool busy() const { return worker_ != nullptr; }
    /// Returns true if the result is there, to be used by finish().
    bool ready() const { return ready_; }
    /// Uses the result. Call it only while it is ready, and no gesture or dialog depends on the state of the window.
    void finish();
    const std::string &name() const { return name_; }
    /// Returns the fraction done in [0, 1]; 0 while it is unknown.
    double fraction() const { return fraction_; }

  private:
    class Worker;

    std::function<void()> wake_;
    std::unique_ptr<Worker> worker_;               ///< null: no task
    std::vector<std::unique_ptr<Worker>> retired_; ///< cancelled; they may still be running
    std::string name_;
    double fraction_ = 0.0;
    bool ready_ = false;
    std::size_t seen_ = 0; ///< number of reports fetched
};

} // namespace forefront
