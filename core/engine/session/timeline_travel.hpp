#pragma once

#include "core/engine/mesher/timeline.hpp"
#include "core/engine/session/breakpoints.hpp"
#include "core/engine/session/meshing_session.hpp"

#include <chrono>
#include <memory>
#include <optional>

namespace forefront {

/// Moves the cursor of a run along its timeline, to a position or at a rate, in batches of about a millisecond, so that
/// the caller of work() can do other things in between.
class TimelineTravel {
  public:
    using Clock = std::chrono::steady_clock;
    /// The result of a call. Arrived: at rest at the target, or as close to it as the run goes. FrontDone: the run
    /// waits for setImprovement(), after which the move goes on.
    enum class Outcome : std::uint8_t { Still, Moved, Arrived, FrontDone };
    /// An explained advance and a moment in it: the index of an event, or the number of events for the whole advance.
    struct Moment {
        std::shared_ptr<const AdvanceExplanation> advance;
        std::size_t cursor = 0;
    };

    explicit TimelineTravel(std::unique_ptr<Mesher> mesher) : timeline_(std::move(mesher)) {}

    const Timeline &timeline() const { return timeline_; }
    bool resting() const { return activity_ == Activity::Resting; }
    /// Returns true while moving at the rate given to play(), and not to a position at full speed.
    bool playing() const { return activity_ == Activity::Playing; }
    /// Returns true once the front is empty at this position.
    bool frontDone() const {
        return eventsDone_ == 0 && timeline_.complete() && timeline_.position() == timeline_.known();
    }
    /// Returns true at the end of the run: of the improvement, if its steps are known.
    bool atEnd() const { return frontDone() && improveStep_ == improveSteps_; }
    /// Makes moves wait at the end of the front for setImprovement().
    void awaitImprovement() { awaitsImprovement_ = true; }
    /// Appends the steps of the improvement to the timeline. `passEnds`: the steps after which a pass ends, ascending.
    /// A run that is at its end without them stays there.
    void setImprovement(std::size_t steps, std::vector<std::size_t> passEnds);
    /// Returns the number of steps of the improvement done at this position, and of all.
    std::size_t improveStep() const { return improveStep_; }
    std::size_t improveSteps() const { return improveSteps_; }
    /// Returns true if the last move led to a position, rather than to the end.
    bool stepped() const { return stepped_; }
    /// Returns the position on the timeline: advances, then steps of the improvement.
    std::uint64_t position() const { return timeline_.position() + improveStep_; }
    /// Returns when work() has something to do next; std::nullopt at rest.
    std::optional<Clock::time_point> workDue() const;
    /// Returns the advances per second of the last batch, or the requested rate.
    double rate() const { return measuredRate_; }
    /// Returns the CPU time of advances, without repeated ones.
    double seconds() const { return seconds_; }
    /// Explains the advance at the cursor. Empty before the first advance and while the cursor moves too fast to
    /// follow.
    Moment explain();

    /// Sets the conditions that stop play(), step() and reachStop().
    void setBreakpoints(const Breakpoints &breakpoints) { breakpoints_ = breakpoints; }
    /// Returns the condition that ended the last move; none if the move reached its target.
    const std::optional<Stop> &stop() const { return stop_; }
    /// Returns the result of the last reachBirth(); empty after any other move.
    const std::optional<Birth> &birth() const { return birth_; }

    /// Computes up to `limit` advances of a run that is at its start, and returns there.
    void lookAhead(std::uint64_t limit);
    /// Begins a move to a position. Positions beyond the known ones are computed.
    Outcome reach(std::uint64_t position);
    /// Begins a move to the end of the run.
    Outcome reachEnd();
    /// Begins a move, back or forward, to the next advance that fulfils a condition, or as far as the run goes.
    Outcome reachStop(bool forward);
    /// Begins a move to the advance that made the node or edge within `tolerance` of a place, or the element around it.
    /// Where nothing is made yet, moves forward until an element covers the place.
    Outcome reachBirth(Vec2 place, double tolerance);
    /// Begins a move of n steps, back if negative, from the cursor or from its target, so that fast steps add up. n
    /// must not be 0.
    Outcome step(Granularity granularity, std::int64_t n);
    /// Begins to move at a number of advances per second, backward if negative. Starts at the beginning if at the end.
    void play(double rate);
    /// Ends the move.
    void rest();
    /// Performs one batch of the move.
    Outcome work();

  private:
    enum class Activity : std::uint8_t { Resting, Reaching, Playing };
    struct Step {
        Granularity granularity = Granularity::Advance;
        std::int64_t count = 0;
    };

    Outcome beginReaching(std::uint64_t position, const Breakpoints &watched);
    Outcome stepAdvances(std::int64_t count);
    Outcome stepEvents(std::int64_t count);
    Outcome stepLayers(std::int64_t count);
    Outcome stepPasses(std::int64_t count);
    void approach(std::uint64_t position);
    bool settle();
    Outcome awaitThen(Step step);
    Outcome reachABatch();
    Outcome playABatch();
    Outcome arrive();
    std::uint64_t move(std::int64_t advances);
    std::uint64_t moveWatching(std::int64_t advances);
    std::uint64_t moveTimeline(std::int64_t advances);
    bool followed() const;
    std::shared_ptr<const AdvanceExplanation> explainNext();

    Timeline timeline_;
    bool awaitsImprovement_ = false;
    std::size_t improveStep_ = 0, improveSteps_ = 0;
    std::vector<std::size_t> passEnds_;
    bool stepped_ = false;
    Activity activity_ = Activity::Resting;
    std::uint64_t target_ = 0;     ///< Reaching: position to reach
    std::size_t targetLayers_ = 0; ///< Reaching: number of layer ends to pass, passes of the improvement among them
    std::optional<Step> next_;     ///< Reaching: step to take at the target, since its end depends on the improvement
    double rate_ = 0.0;            ///< Playing: advances per second; negative: backwards
    double owed_ = 0.0;            ///< Playing: fraction of an advance not yet played
    Clock::time_point lastTick_;   ///< Playing: the time up to which advances are done
    double measuredRate_ = 0.0;
    Breakpoints breakpoints_;
    Breakpoints watched_; ///< conditions of this move
    std::optional<Stop> stop_;
    std::optional<Birth> birth_;
    double seconds_ = 0.0;
    /// Stepping by events: number of events of the next advance, which is explained but not done; 0 between advances.
    std::size_t eventsDone_ = 0;
    std::shared_ptr<const AdvanceExplanation> nextAdvance_;
};

} // namespace forefront
