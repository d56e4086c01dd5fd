#include "ui/parts/fix_trial.hpp"

#include "ui/parts/shell.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Returns true if the judgement is that of the finished mesh with the fix.
bool isJudged(const Shell &context) {
    const SessionSnapshot &run = context.run.now();
    const bool finished = run.state == RunState::Finished && run.complete && run.mesh && !context.run.busy() &&
                          !context.run.preview() && !context.run.outOfDate() && !context.run.showsFile();
    return finished && run.mesh != context.fixTrial->mesh && context.judgement->of.mesh == run.mesh;
}

} // namespace

void tryFix(Shell &context, const LimitVerdict &verdict, LimitFix fix) {
    if (context.applyCommand(std::move(fix.document), "Fix " + std::string(limitInfo(verdict.limit).name))) {
        context.fixTrial =
            FixTrial{verdict, context.run.now().mesh, std::move(fix.change), context.document.revision()};
    }
}

void followFix(Shell &context) {
    if (!context.fixTrial) {
        return;
    }
    if (context.document.revision() != context.fixTrial->revision) {
        context.fixTrial.reset(); // undone, or changed further
        return;
    }
    if (!isJudged(context)) {
        return;
    }
    const FixTrial trial = *std::exchange(context.fixTrial, std::nullopt);
    const std::vector<LimitVerdict> &verdicts = context.judgement->verdicts;
    const auto after = std::find_if(verdicts.begin(), verdicts.end(),
                                    [&](const LimitVerdict &v) { return v.limit == trial.before.limit; });
    if (after != verdicts.end() && makesWorse(trial.before, *after)) {
        context.document.undo();
        context.log.inform("Took back " + trial.change + ": the " + limitInfo(trial.before.limit).name + " became " +
                           valueText(trial.before.limit, after->worst) + " instead of " +
                           valueText(trial.before.limit, trial.before.worst));
        context.animate();
    }
}

} // namespace forefront
