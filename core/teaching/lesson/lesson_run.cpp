#include "core/teaching/lesson/lesson_run.hpp"

#include "core/drawing/domain/document_domain.hpp"
#include "core/engine/base/cancelled.hpp"

#include <algorithm>
#include <utility>

namespace forefront {

Result<LessonRun> LessonRun::create(const LessonPage &page, const Progress &progress) {
    MeshingJob job = jobOf(*documentOf(page));
    const MeshingOptions options = job.options;
    Result<MeshStepper> stepper = MeshStepper::create(std::move(job), progress);
    if (!stepper) {
        return stepper.faults();
    }
    stepper->stepImprovement();
    if (!stepper->finish(progress)) {
        return progress.cancelled() ? cancelled("the run")
                                    : error("unfinished-run", "the run is too large to reach its end",
                                            "choose a larger element size for the drawing");
    }
    LessonRun run(*std::move(stepper), options);
    const std::shared_ptr<const SessionSnapshot> end = run.at({.atEnd = true}, false);
    run.advances_ = end->known;
    run.improveSteps_ = end->improveSteps;
    return run;
}

std::shared_ptr<const SessionSnapshot> LessonRun::at(const LessonPosition &position, bool mesh) {
    if (position.atEnd) {
        stepper_.finish();
    } else {
        stepper_.seek(position.advance);
        stepper_.step(Granularity::Event, position.events);
    }
    return stepper_.snapshot({.mesh = mesh, .front = false, .cells = false, .explanation = true});
}

bool sameRun(const LessonPage &a, const LessonPage &b) {
    return a.document == b.document && a.method == b.method && a.grid == b.grid && a.improve == b.improve &&
           a.rules == b.rules;
}

Result<std::shared_ptr<LessonRun>> LessonRuns::of(const LessonPage &page, const Progress &progress) {
    const auto known =
        std::find_if(runs_.begin(), runs_.end(), [&page](const auto &run) { return sameRun(run.first, page); });
    if (known != runs_.end()) {
        return known->second;
    }
    if (keep_ == Keep::Last) {
        runs_.clear();
    }
    Result<LessonRun> run = LessonRun::create(page, progress);
    if (!run) {
        return run.faults();
    }
    ++made_;
    runs_.emplace_back(page, std::make_shared<LessonRun>(*std::move(run)));
    return runs_.back().second;
}

} // namespace forefront
