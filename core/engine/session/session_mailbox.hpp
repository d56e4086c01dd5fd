#pragma once

#include "core/engine/session/session_command.hpp"
#include "core/engine/session/snapshot.hpp"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>

namespace forefront {

/// Passes commands from the UI thread to the worker of a session, and snapshots back. All members are safe to call from
/// both threads at any time, and only wait() waits for a computation.
class SessionMailbox {
  public:
    using Clock = std::chrono::steady_clock;
    /// A computation during which the worker reads no commands, so that the sender of one must stop it.
    enum class Blocking : std::uint8_t { Nothing, Preparing, Improving, Recording };

    // For the UI thread:

    /// Queues a command, and stops a computation that it ends. Merges it with an adjacent step or seek in the queue.
    void push(SessionCommand command);
    std::shared_ptr<const SessionSnapshot> latest() const;
    bool busy() const;
    /// Waits until the worker has no work left or, if `seen` is given, there is a snapshot with a greater sequence
    /// number. Returns the newest snapshot.
    std::shared_ptr<const SessionSnapshot> wait(std::optional<std::uint64_t> seen) const;
    /// Ends the worker and stops its computation.
    void close();

    // For the worker:

    /// Waits for a command until work is due, or without limit if `workDue` is empty. Returns false and leaves
    /// `command` unchanged if work is due or the mailbox is closed.
    bool take(SessionCommand &command, std::optional<Clock::time_point> workDue);
    bool open() const;
    void deliver(std::shared_ptr<const SessionSnapshot> snapshot);
    /// Begins a computation of this kind. Commands that end it, including those already queued, stop the returned
    /// token.
    std::stop_token beginBlocking(Blocking kind);
    void endBlocking();

  private:
    mutable std::mutex mutex_;
    std::condition_variable changed_;        ///< for the worker: commands, or the end
    mutable std::condition_variable answer_; ///< for the UI thread: a snapshot, or no work left
    std::deque<SessionCommand> commands_;
    std::shared_ptr<const SessionSnapshot> latest_ = std::make_shared<SessionSnapshot>();
    Blocking blocking_ = Blocking::Nothing;
    std::stop_source stop_; ///< stops the blocking computation
    bool active_ = false;
    bool open_ = true;
};

} // namespace forefront
