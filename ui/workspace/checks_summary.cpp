#include "ui/workspace/checks_summary.hpp"

#include "core/engine/mesh/limits.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/workspace.hpp"

#include <algorithm>

namespace forefront {

namespace {

using State = ChecksSummary::State;

std::string counted(std::size_t number, const char *one, const char *several) {
    return ui::count(number) + ' ' + (number == 1 ? one : several);
}

/// Returns a violated limit with the worst value: "minimum angle 32.9° < 34°".
std::string violationText(const LimitVerdict &verdict) {
    const LimitInfo &info = limitInfo(verdict.limit);
    return std::string(info.name) + ' ' + valueText(verdict.limit, verdict.worst) + (info.isMinimum ? " < " : " > ") +
           valueText(verdict.limit, verdict.bound);
}

ChecksSummary limitsSummary(const std::vector<LimitVerdict> &verdicts, bool meshed) {
    const auto violated = [](const LimitVerdict &verdict) { return verdict.broken > 0; };
    const auto broken = static_cast<std::size_t>(std::count_if(verdicts.begin(), verdicts.end(), violated));
    if (broken > 0) {
        const auto first = std::find_if(verdicts.begin(), verdicts.end(), violated);
        const std::string brief = counted(broken, "limit fails", "limits fail");
        return {State::Violated, brief + (broken == 1 ? ": " : ", first ") + violationText(*first), brief};
    }
    const auto judged = static_cast<std::size_t>(
        std::count_if(verdicts.begin(), verdicts.end(), [](const LimitVerdict &verdict) { return verdict.met(); }));
    return judged == 0 ? ChecksSummary{State::Ready, meshed ? "Meshed; no limits to judge" : "Ready to mesh", {}}
                       : ChecksSummary{State::Met, counted(judged, "limit met", "limits met"),
                                       counted(judged, "limit met", "limits met")};
}

/// Adds the number of warnings to a verdict without errors.
ChecksSummary withWarnings(ChecksSummary summary, std::size_t warnings) {
    if (warnings > 0) {
        const std::string text = counted(warnings, "warning", "warnings");
        summary.line += ", " + text;
        summary.brief += (summary.brief.empty() ? "" : ", ") + text;
        summary.warns = true;
    }
    return summary;
}

} // namespace

std::string unfinishedText(const Workspace &context) {
    const SessionSnapshot &run = context.run.now();
    const bool rests = run.state == RunState::Paused || run.state == RunState::Finished ||
                       run.state == RunState::Cancelled || (run.state == RunState::Running && run.playing);
    if (!rests || context.run.showsFile() || run.mesh == nullptr || run.atEnd()) {
        return {};
    }
    if (run.frontDone()) {
        return "Unfinished mesh: step " + ui::count(run.improveStep) + " of " + ui::count(run.improveSteps) +
               " of the improvement";
    }
    return "Unfinished mesh: advance " + ui::count(run.advance) +
           (run.complete ? " of " + ui::count(run.known) : ", the end is not reached yet");
}

ChecksSummary checksSummary(const Workspace &context) {
    const Diagnostics &faults = context.preview->faults;
    const auto errors = static_cast<std::size_t>(std::count_if(
        faults.begin(), faults.end(), [](const Diagnostic &fault) { return fault.severity == Severity::Error; }));
    if (errors > 0) {
        const std::string brief = counted(errors, "error", "errors");
        return {State::Violated, brief + " in the drawing", brief};
    }
    if (context.run.now().mesh == nullptr && context.document.current()->shapes.empty()) {
        return {};
    }
    if (const std::string unfinished = unfinishedText(context); !unfinished.empty()) {
        return {State::Unfinished, unfinished + "; its limits are judged at the end", "unfinished mesh", true};
    }
    const auto warnings = static_cast<std::size_t>(std::count_if(
        faults.begin(), faults.end(), [](const Diagnostic &fault) { return fault.severity == Severity::Warning; }));
    return withWarnings(
        limitsSummary(context.judgement->verdicts, context.run.now().mesh != nullptr && !context.run.outOfDate()),
        warnings);
}

} // namespace forefront
