#include "core/engine/session/timeline_travel.hpp"

#include "core/engine/base/cpu_clock.hpp"
#include "core/engine/session/breakpoint_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace forefront {

namespace {

using namespace std::chrono_literals;

/// Duration of a batch of advances, short enough to answer commands at once.
constexpr std::int64_t kBatch = 512;
constexpr auto kTick = 16ms;
constexpr std::uint64_t kToTheEnd = std::numeric_limits<std::uint64_t>::max();
/// Maximum rate at which single advances are explained.
constexpr double kExplainedRate = 120.0;

} // namespace

std::optional<TimelineTravel::Clock::time_point> TimelineTravel::workDue() const {
    switch (activity_) {
    case Activity::Resting:
        break;
    case Activity::Reaching:
        return Clock::time_point{};
    case Activity::Playing:
        return lastTick_ + kTick;
    }
    return std::nullopt;
}

bool TimelineTravel::followed() const {
    return activity_ == Activity::Resting || (activity_ == Activity::Playing && std::abs(rate_) <= kExplainedRate);
}

std::shared_ptr<const AdvanceExplanation> TimelineTravel::explainNext() {
    return std::make_shared<const AdvanceExplanation>(timeline_.mesher().explainNext());
}

/// Explains the advance that contains the cursor, or else the last one, by doing it again with recording.
TimelineTravel::Moment TimelineTravel::explain() {
    Moment moment;
    if (!followed()) {
        return moment;
    }
    if (improveStep_ > 0 && !atEnd()) {
        return moment;
    }
    if (eventsDone_ > 0) {
        moment = {nextAdvance_, eventsDone_ - 1};
    } else if (timeline_.position() > 0) {
        timeline_.back(1);
        moment.advance = explainNext();
        timeline_.forward(1);
        moment.cursor = moment.advance->events.size();
    }
    return moment;
}

void TimelineTravel::lookAhead(std::uint64_t limit) {
    move(static_cast<std::int64_t>(limit));
    timeline_.approach(0);
    moveTimeline(-static_cast<std::int64_t>(timeline_.position()));
}

void TimelineTravel::setImprovement(std::size_t steps, std::vector<std::size_t> passEnds) {
    if (atEnd() && !awaitsImprovement_) {
        improveStep_ = steps;
    }
    awaitsImprovement_ = false;
    improveSteps_ = steps;
    passEnds_ = std::move(passEnds);
}

/// Jumps near a position of the front, or leaves the cursor where it is in the improvement.
void TimelineTravel::approach(std::uint64_t position) {
    if (improveStep_ > 0 && position >= timeline_.known()) {
        return;
    }
    improveStep_ = 0;
    timeline_.approach(position);
}

TimelineTravel::Outcome TimelineTravel::reach(std::uint64_t position) {
    approach(position);
    return beginReaching(position, {});
}

TimelineTravel::Outcome TimelineTravel::beginReaching(std::uint64_t position, const Breakpoints &watched) {
    watched_ = watched;
    stop_.reset();
    birth_.reset();
    eventsDone_ = 0;
    targetLayers_ = 0;
    next_.reset();
    target_ = position;
    stepped_ = position != kToTheEnd;
    activity_ = Activity::Reaching;
    return this->position() == target_ ? arrive() : Outcome::Still;
}

TimelineTravel::Outcome TimelineTravel::reachEnd() {
    return reach(kToTheEnd);
}

TimelineTravel::Outcome TimelineTravel::reachStop(bool forward) {
    return beginReaching(forward ? kToTheEnd : 0, breakpoints_);
}

TimelineTravel::Outcome TimelineTravel::reachBirth(Vec2 place, double tolerance) {
    settle();
    if (const std::optional<Birth> birth = birthAt(timeline_, place, tolerance)) {
        const Outcome outcome = reach(birth->advance);
        birth_ = birth;
        return outcome;
    }
    if (!unmeshed(timeline_.mesher().state().front, place)) {
        return reach(position());
    }
    Breakpoints covered;
    covered.set(StopKind::Place, true);
    covered.place = place;
    return beginReaching(kToTheEnd, covered);
}

TimelineTravel::Outcome TimelineTravel::step(Granularity granularity, std::int64_t n) {
    switch (granularity) {
    case Granularity::Event:
        return settle() ? stepEvents(n) : awaitThen({granularity, n});
    case Granularity::Advance:
        return stepAdvances(n);
    case Granularity::Layer:
        return settle() ? stepLayers(n) : awaitThen({granularity, n});
    }
    return Outcome::Arrived;
}

TimelineTravel::Outcome TimelineTravel::stepAdvances(std::int64_t count) {
    const bool underWay = activity_ == Activity::Reaching && target_ != kToTheEnd;
    const std::uint64_t origin = underWay ? target_ : position();
    if (count > 0) {
        return beginReaching(origin + static_cast<std::uint64_t>(count), breakpoints_);
    }
    // Within an advance, the first step back leads to its start.
    const auto back = static_cast<std::uint64_t>(-count) - (eventsDone_ > 0 ? 1 : 0);
    return beginReaching(origin - std::min(origin, back), breakpoints_);
}

/// Completes a short move, since the next one starts from its target. Returns false if the target is a step of the
/// improvement, which is yet to be made.
bool TimelineTravel::settle() {
    for (int batch = 0; batch < 64 && activity_ == Activity::Reaching && target_ != kToTheEnd; ++batch) {
        if (reachABatch() == Outcome::FrontDone && target_ != position()) {
            return false;
        }
    }
    activity_ = Activity::Resting;
    return true;
}

/// Takes a step once the improvement is made and the target reached.
TimelineTravel::Outcome TimelineTravel::awaitThen(Step step) {
    if (next_ && next_->granularity == step.granularity) {
        step.count += next_->count; // several in a row
    }
    next_ = step;
    return Outcome::FrontDone;
}

TimelineTravel::Outcome TimelineTravel::stepEvents(std::int64_t count) {
    watched_ = breakpoints_;
    stop_.reset();
    birth_.reset();
    stepped_ = true;
    for (; count > 0 && !stop_; --count) {
        if (eventsDone_ == 0) {
            if (timeline_.mesher().finished()) { // steps of the improvement have no events
                if (awaitsImprovement_) {
                    return beginReaching(position() + static_cast<std::uint64_t>(count), breakpoints_);
                }
                move(count);
                break;
            }
            nextAdvance_ = explainNext();
        }
        if (++eventsDone_ >= nextAdvance_->events.size()) {
            eventsDone_ = 0;
            move(1);
        }
    }
    for (; count < 0 && !stop_; ++count) {
        if (eventsDone_ == 0) {
            const bool improving = improveStep_ > 0;
            if (move(-1) == 0) {
                break;
            }
            if (improving) {
                continue;
            }
            nextAdvance_ = explainNext();
            eventsDone_ = nextAdvance_->events.size();
        }
        --eventsDone_;
    }
    return arrive();
}

/// Steps to the ends of passes of the improvement, and back to its start.
TimelineTravel::Outcome TimelineTravel::stepPasses(std::int64_t count) {
    std::vector<std::size_t> ends{0};
    ends.insert(ends.end(), passEnds_.begin(), passEnds_.end());
    const auto last = static_cast<std::int64_t>(ends.size()) - 1;
    const std::int64_t from = count > 0 ? (std::ranges::upper_bound(ends, improveStep_) - ends.begin()) - 1
                                        : std::ranges::lower_bound(ends, improveStep_) - ends.begin();
    const std::int64_t pass = std::clamp<std::int64_t>(from + count, 0, last);
    return beginReaching(timeline_.known() + ends[static_cast<std::size_t>(pass)], breakpoints_);
}

TimelineTravel::Outcome TimelineTravel::stepLayers(std::int64_t count) {
    if (improveStep_ > 0 || (count > 0 && frontDone() && !awaitsImprovement_)) {
        return stepPasses(count);
    }
    const std::vector<std::uint64_t> &ends = timeline_.layerEnds();
    const std::uint64_t position = timeline_.position();
    if (count > 0) {
        const auto above = std::upper_bound(ends.begin(), ends.end(), position) - ends.begin();
        const Outcome outcome = beginReaching(kToTheEnd, breakpoints_);
        stepped_ = true;
        targetLayers_ = static_cast<std::size_t>(above + count);
        return outcome;
    }
    // Within an advance, the first step back may lead to its start.
    const std::uint64_t from = position + (eventsDone_ > 0 ? 1 : 0);
    const auto below = std::lower_bound(ends.begin(), ends.end(), from) - ends.begin();
    const std::int64_t layer = below + count;
    return beginReaching(layer < 0 ? 0 : ends[static_cast<std::size_t>(layer)], breakpoints_);
}

void TimelineTravel::play(double rate) {
    if (rate > 0.0 && atEnd() && !awaitsImprovement_) {
        approach(0); // a checkpoint, so that this takes no time
    }
    stepped_ = false;
    watched_ = breakpoints_;
    stop_.reset();
    birth_.reset();
    eventsDone_ = 0;
    next_.reset();
    rate_ = rate;
    owed_ = 0.0;
    lastTick_ = Clock::now();
    activity_ = Activity::Playing;
}

void TimelineTravel::rest() {
    activity_ = Activity::Resting;
    next_.reset();
}

TimelineTravel::Outcome TimelineTravel::arrive() {
    if (awaitsImprovement_ && frontDone()) {
        return Outcome::FrontDone;
    }
    const std::optional<Step> next = next_;
    rest();
    return next && !stop_ ? step(next->granularity, next->count) : Outcome::Arrived;
}

TimelineTravel::Outcome TimelineTravel::work() {
    switch (activity_) {
    case Activity::Resting:
        break;
    case Activity::Reaching:
        return reachABatch();
    case Activity::Playing:
        return playABatch();
    }
    return Outcome::Arrived;
}

/// Counts the time of advances as meshing time unless they are repeated.
std::uint64_t TimelineTravel::move(std::int64_t advances) {
    CpuClock clock;
    const auto begin = Clock::now();
    const std::uint64_t knownBefore = timeline_.known();
    const std::uint64_t done = watched_.any() ? moveWatching(advances) : moveTimeline(advances);
    if (timeline_.known() > knownBefore) {
        seconds_ += clock.lap();
    }
    const double wall = std::chrono::duration<double>(Clock::now() - begin).count();
    if (activity_ == Activity::Reaching && wall > 0.0) {
        measuredRate_ = static_cast<double>(done) / wall;
    }
    return done;
}

std::uint64_t TimelineTravel::moveTimeline(std::int64_t advances) {
    const auto count = static_cast<std::uint64_t>(std::abs(advances));
    if (advances >= 0) {
        const std::uint64_t done = timeline_.forward(count);
        const std::uint64_t more = std::min<std::uint64_t>(count - done, improveSteps_ - improveStep_);
        improveStep_ += static_cast<std::size_t>(more);
        return done + more;
    }
    const std::uint64_t undone = std::min<std::uint64_t>(count, improveStep_);
    improveStep_ -= static_cast<std::size_t>(undone);
    return undone + timeline_.back(count - undone);
}

/// Moves one advance at a time until one fulfils a condition, since conditions look at the state after the advance.
std::uint64_t TimelineTravel::moveWatching(std::int64_t advances) {
    std::uint64_t done = 0;
    for (std::int64_t left = std::abs(advances); left > 0 && !stop_; --left) {
        if (moveTimeline(advances > 0 ? 1 : -1) == 0) {
            break;
        }
        ++done;
        if (improveStep_ == 0) { // the conditions are on advances
            stop_ = stopAfterLast(watched_, timeline_);
        }
    }
    return done;
}

TimelineTravel::Outcome TimelineTravel::reachABatch() {
    if (targetLayers_ > 0 && timeline_.layerEnds().size() >= targetLayers_) {
        target_ = timeline_.layerEnds()[targetLayers_ - 1];
        targetLayers_ = 0;
    }
    if (targetLayers_ > 0 && frontDone() && !awaitsImprovement_) { // passes of the improvement follow the last layer
        const std::size_t pass = std::min(targetLayers_ - timeline_.layerEnds().size(), passEnds_.size());
        target_ = timeline_.known() + (pass == 0 ? 0 : passEnds_[pass - 1]);
        targetLayers_ = 0;
    }
    const std::uint64_t position = this->position();
    std::uint64_t done = 0;
    if (target_ > position) {
        done = move(static_cast<std::int64_t>(std::min<std::uint64_t>(target_ - position, kBatch)));
    } else if (target_ < position) {
        done = move(-static_cast<std::int64_t>(std::min<std::uint64_t>(position - target_, kBatch)));
    }
    if (this->position() != target_ && done != 0 && !atEnd() && !stop_) {
        return Outcome::Moved;
    }
    return arrive();
}

TimelineTravel::Outcome TimelineTravel::playABatch() {
    const auto now = Clock::now();
    owed_ += rate_ * std::chrono::duration<double>(now - lastTick_).count();
    lastTick_ = now;
    // A slow machine plays more slowly instead of falling ever further behind.
    const double limit = 0.05 * std::abs(rate_) + 1.0;
    owed_ = std::clamp(owed_, -limit, limit);
    const auto due = static_cast<std::int64_t>(owed_);
    if (due == 0) {
        return Outcome::Still;
    }
    owed_ -= static_cast<double>(due);
    measuredRate_ = std::abs(rate_);
    std::int64_t left = due;
    while (left != 0 && Clock::now() - now < kTick) {
        const std::int64_t batch = std::clamp<std::int64_t>(left, -kBatch, kBatch);
        const std::uint64_t done = move(batch);
        left -= batch;
        if (stop_ || done < static_cast<std::uint64_t>(std::abs(batch))) {
            return arrive();
        }
    }
    return rate_ > 0.0 && atEnd() ? arrive() : Outcome::Moved;
}

} // namespace forefront
