#pragma once

#include "core/session/session_command.hpp"
#include "core/session/snapshot.hpp"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>

namespace forefront {

/// What the UI's thread and the worker of a session exchange: commands one way, snapshots the other. Safe to call from
/// both threads at any time; none of its members waits for a computation.
class SessionMailbox {
  public:
    using Clock = std::chrono::steady_clock;
    /// What the worker computes without looking at the commands, and so must be stopped by the sender of one.
    enum class Blocking : std::uint8_t { Nothing, Preparing, Improving };

    /// The sender's side. Steps and seeks that wait one behind the other are merged.
    void push(SessionCommand command);
    std::shared_ptr<const SessionSnapshot> latest() const;
    bool busy() const;
    /// Tells the worker to end; stops what it computes.
    void close();

    /// The worker's side. Waits for a command until work is due, or without end where there is no work (`workDue`
    /// empty). False, and `command` as it was: the work is due, or the mailbox has been closed.
    bool take(SessionCommand &command, std::optional<Clock::time_point> workDue);
    bool open() const;
    void deliver(std::shared_ptr<const SessionSnapshot> snapshot);
    /// The token is stopped by the commands that put an end to a computation of this kind, those already waiting too.
    std::stop_token beginBlocking(Blocking kind);
    void endBlocking();

  private:
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<SessionCommand> commands_;
    std::shared_ptr<const SessionSnapshot> latest_ = std::make_shared<SessionSnapshot>();
    Blocking blocking_ = Blocking::Nothing;
    std::stop_source stop_; ///< of the blocking computation
    bool active_ = false;
    bool open_ = true;
};

} // namespace forefront
