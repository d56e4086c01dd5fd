#include "ui/workspace/view/step_text.hpp"

#include "ui/widgets/widgets.hpp"

#include <cstddef>

namespace forefront {

namespace {

/// Returns the candidate whose score is shown: the accepted one once it is known, else the one scored last.
const CandidateTrace *scored(const Moment &moment) {
    const AdvanceExplanation &e = *moment.advance;
    for (std::size_t i = 0; i < moment.candidates; ++i) {
        if (moment.judged[i] && e.candidates[i].verdict == Verdict::Accepted) {
            return &e.candidates[i];
        }
    }
    const CandidateTrace *found = nullptr;
    for (std::size_t i = 0; i < e.events.size() && i <= moment.cursor + 1; ++i) { // sorted right after it is scored
        const TraceEvent &event = e.events[i];
        found = event.step == Step::Sort && event.candidate != kNoIndex ? &e.candidates[event.candidate] : found;
    }
    return found;
}

/// Returns the work of the background grid in a step: " of 23 in 4 cells".
std::string workText(const Moment &moment, Step step) {
    const StepWork &work = moment.work[static_cast<std::size_t>(step)];
    return work.segments == 0 ? std::string()
                              : " of " + ui::count(work.segments) + " in " + ui::count(work.cells) +
                                    (work.cells == 1 ? " cell" : " cells");
}

} // namespace

std::string stepFinding(const Moment &moment, Step step) {
    if (!moment || moment.step < step) {
        return {};
    }
    const AdvanceExplanation &e = *moment.advance;
    switch (step) {
    case Step::TakeBase:
        return e.nodeA == kNoNode ? std::string()
                                  : std::to_string(index(e.nodeA)) + "\xe2\x80\x93" + std::to_string(index(e.nodeB));
    case Step::EvaluateSpacing:
        return ui::number(e.rho, 3);
    case Step::IdealPoint:
        return "(" + ui::number(e.ideal.x) + ", " + ui::number(e.ideal.y) + ")";
    case Step::FindCandidates:
        return ui::count(moment.candidates) + workText(moment, Step::FindCandidates);
    case Step::Score: {
        const CandidateTrace *best = scored(moment);
        return best == nullptr
                   ? std::string()
                   : ui::format("%.3f \xc2\xb7 %.2f \xc2\xb7 %.2f", best->alpha, best->deltaAC, best->deltaCB);
    }
    case Step::Test:
        return ui::count(moment.tests) + workText(moment, Step::Test);
    case Step::Update:
        return e.deferred ? "deferred" : std::string();
    default:
        return {};
    }
}

std::optional<Step> liveStep(const SessionSnapshot &run, const Moment &moment) {
    if (moment) {
        return moment.step;
    }
    if (run.state == RunState::Empty || run.state == RunState::Failed) {
        return std::nullopt;
    }
    if (run.frontDone()) {
        return Step::Finish;
    }
    return run.advance == 0 ? std::optional(Step::BoundaryToFront) : std::nullopt;
}

} // namespace forefront
