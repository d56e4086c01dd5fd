#include "core/teaching/lesson/lesson_run.hpp"

#include "core/drawing/domain/document_domain.hpp"
#include "core/engine/base/cancelled.hpp"

#include <utility>

namespace forefront {

Result<LessonRun> LessonRun::create(const LessonPage &page, const Progress &progress) {
    Result<MeshStepper> stepper = MeshStepper::create(jobOf(*documentOf(page)), progress);
    if (!stepper) {
        return stepper.faults();
    }
    stepper->stepImprovement();
    if (!stepper->finish(progress)) {
        return progress.cancelled() ? cancelled("the run")
                                    : error("unfinished-run", "the run is too large to reach its end",
                                            "choose a larger element size for the drawing");
    }
    LessonRun run(*std::move(stepper));
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

} // namespace forefront
