#include "ui/parts/fix_trial.hpp"

#include "ui/parts/shell.hpp"

#include <optional>
#include <string>
#include <utility>

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
        context.fixTrial = FixTrial{context.judgement->verdicts, context.run.now().mesh, std::move(fix.change),
                                    context.document.revision()};
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
    const std::string why = whyNoBetter(trial.before, context.judgement->verdicts);
    if (!why.empty()) {
        context.document.undo();
        context.log.inform("Took back " + trial.change + ": " + why);
        context.animate();
    }
}

} // namespace forefront
