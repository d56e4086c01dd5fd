#include "core/engine/session/session_mailbox.hpp"

#include <algorithm>

namespace forefront {

namespace {

bool endsTheRun(const SessionCommand &command) {
    return std::holds_alternative<StartCommand>(command) || std::holds_alternative<ClearCommand>(command) ||
           std::holds_alternative<CancelCommand>(command);
}

/// Returns true if a command ends a computation: preparation and the record of the improvement end with the run,
/// improvement with any movement.
bool stops(const SessionCommand &command, SessionMailbox::Blocking kind) {
    const bool movesNothing = std::holds_alternative<LayersCommand>(command) ||
                              std::holds_alternative<FinishCommand>(command) ||
                              std::holds_alternative<BreakpointsCommand>(command);
    return endsTheRun(command) || (kind == SessionMailbox::Blocking::Improving && !movesNothing);
}

/// Merges a command into the one waiting before it: steps in the same direction add up, and a later seek replaces an
/// earlier one. A held key or a dragged scrubber therefore never queues more work than a large mesh can follow.
bool mergeInto(SessionCommand &waiting, const SessionCommand &next) {
    if (const auto *step = std::get_if<StepCommand>(&next)) {
        auto *before = std::get_if<StepCommand>(&waiting);
        const bool sameWay =
            before != nullptr && before->granularity == step->granularity && (before->count > 0) == (step->count > 0);
        if (sameWay) {
            before->count += step->count;
        }
        return sameWay;
    }
    if (std::holds_alternative<SeekCommand>(next) && std::holds_alternative<SeekCommand>(waiting)) {
        waiting = next;
        return true;
    }
    return false;
}

} // namespace

void SessionMailbox::push(SessionCommand command) {
    {
        const std::lock_guard lock(mutex_);
        if (stops(command, blocking_)) {
            stop_.request_stop();
        }
        if (commands_.empty() || !mergeInto(commands_.back(), command)) {
            commands_.push_back(std::move(command));
        }
    }
    changed_.notify_all();
}

std::shared_ptr<const SessionSnapshot> SessionMailbox::latest() const {
    const std::lock_guard lock(mutex_);
    return latest_;
}

bool SessionMailbox::busy() const {
    const std::lock_guard lock(mutex_);
    return active_ || !commands_.empty();
}

std::shared_ptr<const SessionSnapshot> SessionMailbox::wait(std::optional<std::uint64_t> seen) const {
    std::unique_lock lock(mutex_);
    answer_.wait(lock, [&] { return (!active_ && commands_.empty()) || (seen && latest_->sequence > *seen); });
    return latest_;
}

void SessionMailbox::close() {
    {
        const std::lock_guard lock(mutex_);
        open_ = false;
        stop_.request_stop();
    }
    changed_.notify_all();
}

bool SessionMailbox::take(SessionCommand &command, std::optional<Clock::time_point> workDue) {
    std::unique_lock lock(mutex_);
    const auto ready = [this] { return !commands_.empty() || !open_; };
    active_ = workDue.has_value();
    if (!active_ && commands_.empty()) {
        answer_.notify_all();
    }
    if (workDue) {
        changed_.wait_until(lock, *workDue, ready);
    } else {
        changed_.wait(lock, ready);
    }
    if (commands_.empty() || !open_) {
        return false;
    }
    command = std::move(commands_.front());
    commands_.pop_front();
    active_ = true;
    return true;
}

bool SessionMailbox::open() const {
    const std::lock_guard lock(mutex_);
    return open_;
}

void SessionMailbox::deliver(std::shared_ptr<const SessionSnapshot> snapshot) {
    {
        const std::lock_guard lock(mutex_);
        latest_.swap(snapshot);
    }
    answer_.notify_all();
}

std::stop_token SessionMailbox::beginBlocking(Blocking kind) {
    const std::lock_guard lock(mutex_);
    stop_ = std::stop_source{};
    const bool stopped = std::any_of(commands_.begin(), commands_.end(),
                                     [kind](const SessionCommand &command) { return stops(command, kind); });
    if (stopped || !open_) {
        stop_.request_stop();
    }
    blocking_ = kind;
    return stop_.get_token();
}

void SessionMailbox::endBlocking() {
    const std::lock_guard lock(mutex_);
    blocking_ = Blocking::Nothing;
}

} // namespace forefront
