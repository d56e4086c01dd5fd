#pragma once

#include "core/mesher/timeline.hpp"
#include "core/session/meshing_session.hpp"

#include <chrono>
#include <memory>
#include <optional>

namespace forefront {

/// Moves the cursor of a run over its timeline, to a place or at a pace, in batches of about a millisecond, so that
/// whoever calls work() can look at other things in between.
class TimelineTravel {
  public:
    using Clock = std::chrono::steady_clock;
    /// What a call did. Arrived: where the way led, or as far as it goes; at rest there.
    enum class Way : std::uint8_t { Still, Moved, Arrived };
    /// What the run explains at the cursor: an advance and the moment inside it, its event count for the whole of it.
    struct Moment {
        std::shared_ptr<const AdvanceExplanation> advance;
        std::size_t cursor = 0;
    };

    explicit TimelineTravel(std::unique_ptr<Mesher> mesher) : timeline_(std::move(mesher)) {}

    const Timeline &timeline() const { return timeline_; }
    bool resting() const { return activity_ == Activity::Resting; }
    /// Moving at the pace that play() was given, for the eye; not on the way to a place as fast as can be.
    bool playing() const { return activity_ == Activity::Playing; }
    /// At the end of the whole run, and not inside an advance.
    bool atEnd() const { return eventsDone_ == 0 && timeline_.complete() && timeline_.position() == timeline_.known(); }
    /// When work() has something to do; none at rest.
    std::optional<Clock::time_point> workDue() const;
    /// Advances per second: those of the last batch, or the pace that was asked for.
    double rate() const { return measuredRate_; }
    /// CPU time spent on advances done for the first time.
    double seconds() const { return seconds_; }
    /// Nothing before the first advance, and while the cursor moves too fast to be followed.
    Moment explain();

    /// Sets out for a position in [0, the end]; beyond the known ones it computes on.
    Way reach(std::uint64_t position);
    Way reachEnd();
    /// Sets out n steps from where the cursor is, or is on its way to: steps that come faster than they are done add
    /// up. Negative: back. n must not be 0.
    Way step(Granularity granularity, std::int64_t n);
    /// Moves at a number of advances per second, negative: back. Forward from the end it starts at the beginning.
    void play(double rate);
    void rest();
    /// One batch.
    Way work();

  private:
    enum class Activity : std::uint8_t { Resting, Reaching, Playing };

    Way stepAdvances(std::int64_t count);
    Way stepEvents(std::int64_t count);
    Way stepLayers(std::int64_t count);
    void settle();
    void startPlaying(double rate);
    Way reachABatch();
    Way playABatch();
    Way arrive();
    std::uint64_t move(std::int64_t advances);
    bool followed() const;
    std::shared_ptr<const AdvanceExplanation> explainNext();

    Timeline timeline_;
    Activity activity_ = Activity::Resting;
    std::uint64_t target_ = 0;     ///< Reaching: position to reach
    std::size_t layersWanted_ = 0; ///< Reaching: so many layer ends, then the last of them is the target
    double rateOnArrival_ = 0.0;   ///< Reaching: then play at this rate; 0: rest
    double rate_ = 0.0;            ///< Playing: advances per second, negative: back
    double owed_ = 0.0;            ///< Playing: fraction of an advance not yet played
    Clock::time_point lastTick_;   ///< Playing: up to when advances have been paid
    double measuredRate_ = 0.0;
    double seconds_ = 0.0;
    /// Stepping by events: inside the next advance, which is explained but not done. 0: outside.
    std::size_t eventsDone_ = 0;
    std::shared_ptr<const AdvanceExplanation> nextAdvance_;
};

} // namespace forefront
