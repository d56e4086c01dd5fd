#include "core/teaching/moment/moment.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// Above this rate, in advances per second, single advances cannot be followed and only the front is shown.
constexpr double kFollowed = 40.0;

/// Attributes the work between two events to the step of the second.
void addWork(Moment &moment) {
    const std::vector<TraceEvent> &events = moment.advance->events;
    StepWork before;
    for (std::size_t i = 0; i < events.size() && i <= moment.cursor; ++i) {
        StepWork &work = moment.work[static_cast<std::size_t>(events[i].step)];
        work.cells += events[i].cellsSeen - before.cells;
        work.segments += events[i].delivered - before.segments;
        before = {events[i].cellsSeen, events[i].delivered};
    }
}

} // namespace

Moment momentOf(const SessionSnapshot &snapshot) {
    Moment moment;
    const bool racing = snapshot.state == RunState::Running && snapshot.rate > kFollowed;
    if (!snapshot.explanation || snapshot.improved || racing || snapshot.state == RunState::Improving) {
        return moment;
    }
    const AdvanceExplanation &advance = *snapshot.explanation;
    moment.advance = &advance;
    const std::size_t count = advance.events.size();
    moment.cursor = snapshot.eventCount > 0 ? std::min(snapshot.eventCursor, count) : count;
    const bool whole = moment.cursor >= count;
    moment.step = whole ? Step::Update : advance.events[moment.cursor].step;
    moment.judged.assign(advance.candidates.size(), whole);
    moment.tests = whole ? advance.tests.size() : 0;
    moment.cells = whole ? advance.cells.size() : 0;
    moment.candidates = whole ? advance.candidates.size() : advance.events[moment.cursor].candidatesSeen;
    for (std::size_t i = 0; i < count && i <= moment.cursor && !whole; ++i) {
        const TraceEvent &event = advance.events[i];
        moment.cells = std::max<std::size_t>(moment.cells, event.cellsSeen);
        if (event.test != kNoIndex) {
            moment.tests = std::max<std::size_t>(moment.tests, event.test + 1U);
        }
        // The verdict on a candidate is known once the next one is tested or Γ is updated.
        const bool later = i < moment.cursor;
        if (event.step == Step::Test && event.candidate < moment.judged.size() && later) {
            const TraceEvent &next = advance.events[i + 1];
            moment.judged[event.candidate] = next.step != Step::Test || next.candidate != event.candidate;
        }
        if (event.step == Step::Sort && advance.events.size() > i) {
            for (std::size_t c = 0; c < advance.candidates.size(); ++c) {
                const Verdict verdict = advance.candidates[c].verdict;
                moment.judged[c] = moment.judged[c] || verdict == Verdict::Withdrawn || verdict == Verdict::OneColour ||
                                   verdict == Verdict::FlatCorner;
            }
        }
    }
    moment.cells = std::min(moment.cells, advance.cells.size());
    moment.tests = std::min(moment.tests, advance.tests.size());
    moment.idealKnown = moment.step >= Step::IdealPoint;
    moment.candidatesKnown = moment.step >= Step::FindCandidates;
    moment.scoresKnown = moment.step >= Step::Score;
    moment.updated = moment.step >= Step::Update && !advance.deferred;
    addWork(moment);
    return moment;
}

} // namespace forefront
