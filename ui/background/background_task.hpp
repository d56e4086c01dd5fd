#pragma once

#include "core/engine/base/progress.hpp"
#include "ui/background/latest.hpp"

#include <functional>
#include <optional>
#include <string>

namespace forefront {

/// A long task of the window on a separate thread, such as reading a file. At most one result is awaited: another start
/// cancels the earlier task. Call all members from one thread; none of them waits, except the destructor, which leaves
/// a thread behind that hangs in reading a file.
class BackgroundTask {
  public:
    /// Uses the result, on the thread that calls finish(); empty: nothing to do.
    using Finish = std::function<void()>;
    /// Runs on the thread of the task, and may use only what it owns or shares; see LeavableThread.
    using Work = std::function<Finish(const Progress &)>;

    explicit BackgroundTask(BackgroundList &list);

    /// Starts a task; `purpose`: such as "reading plate.msh".
    void start(std::string purpose, Work work);
    /// Drops the task and its result. Its thread ends by itself, when it next checks its stop token.
    void cancel();
    /// Fetches the newest progress. Called once per frame; returns true if it has changed.
    bool refresh() { return worker_.refresh(); }
    /// Returns true until the result has been used.
    bool busy() const { return busy_; }
    /// Returns true if the result is there, to be used by finish().
    bool ready() const { return worker_.now().result.has_value(); }
    /// Uses the result. Call it only while it is ready, and no gesture or dialog depends on the state of the window.
    void finish();
    /// Returns the current stage of the task, such as "finding the outline".
    const std::string &name() const { return worker_.now().name; }
    /// Returns the purpose of the task, as given to start().
    const std::string &purpose() const { return purpose_; }
    /// Returns the fraction done in [0, 1]; 0 while it is unknown.
    double fraction() const { return worker_.now().fraction; }

  private:
    /// How far a task is.
    struct State {
        std::string name;
        double fraction = 0.0;
        std::optional<Finish> result{}; ///< none until it is there
    };

    /// The purpose of a task, and its work.
    struct Request {
        std::string purpose;
        Work work;
    };

    static State answer(const LatestTurn<Request, State> &turn);

    std::string purpose_;
    bool busy_ = false;
    Latest<Request, State> worker_;
};

} // namespace forefront
