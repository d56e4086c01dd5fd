#include "ui/workspace/document/layer_planner.hpp"

#include "core/drawing/document/document.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/pipeline/layer_plan.hpp"

#include <new>
#include <utility>

namespace forefront {

LayerPlanner::LayerPlanner(BackgroundList &list) : worker_(list, answer, std::make_shared<LayerPlan>()) {}

void LayerPlanner::submit(std::shared_ptr<SharedDomain> drawn, std::uint64_t revision,
                          std::shared_ptr<SharedSpacing> spacing) {
    if (revision == wanted_) {
        return;
    }
    wanted_ = revision;
    if (drawn->document()->layers.empty()) { // needs no thread
        worker_.clear(std::make_shared<LayerPlan>(LayerPlan{revision, {}}));
        return;
    }
    worker_.requestStop();
    worker_.submit({std::move(drawn), std::move(spacing), revision});
}

void LayerPlanner::abandon() {
    if (wanted_ == 0) {
        return;
    }
    wanted_ = 0;
    worker_.clear(std::make_shared<LayerPlan>());
}

LayerPlanner::Answer LayerPlanner::answer(const LatestTurn<Request, Answer> &turn) {
    auto plan = std::make_shared<LayerPlan>();
    plan->revision = turn.request.revision;
    try {
        MeshingJob job = *turn.request.drawn->job();
        job.shared = turn.request.spacing;
        Progress progress;
        progress.stop = turn.stop;
        Result<LayerRows> rows = planLayerRows(job, progress);
        if (progress.cancelled()) {
            return turn.earlier;
        }
        if (rows) { // else the faults of the drawing are shown, or those of its next run
            plan->rows = *std::move(rows);
        }
    } catch (const std::bad_alloc &) { // without a picture of layers, all else goes on
        plan->rows = {};
    }
    return plan;
}

} // namespace forefront
