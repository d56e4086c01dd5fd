#include "core/engine/pipeline/stages.hpp"

#include "core/engine/base/cancelled.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace forefront {

std::span<const Stage> stagesBeforeFront() {
    static constexpr std::array kStages = {
        Stage{StageTime::Prepare, validateStage},   Stage{StageTime::Prepare, spacingStage},
        Stage{StageTime::Prepare, stripsStage},     Stage{StageTime::Prepare, boundaryStage},
        Stage{StageTime::Prepare, mappedStage},     Stage{StageTime::Prepare, layersStage},
        Stage{StageTime::Mesh, regionElementsStage}};
    return kStages;
}

std::span<const Stage> stagesOfPlan() {
    return stagesBeforeFront().first(stagesBeforeFront().size() - 1); // regionElementsStage is the last
}

std::span<const Stage> stagesBeforeLayers() {
    return stagesOfPlan().first(stagesOfPlan().size() - 1); // layersStage is the last
}

namespace {

bool makesTriangles(const MeshingOptions &options) {
    return !makesQuads(options);
}
bool improvesTriangles(const MeshingOptions &options) {
    return makesTriangles(options) && options.improve != ImproveLevel::None;
}
bool hasLeastAngle(const MeshingOptions &options) {
    return makesTriangles(options) && options.leastAngle.has_value();
}
bool improvesQuads(const MeshingOptions &options) {
    return makesQuads(options) && options.improve != ImproveLevel::None;
}
bool raisesOrder(const MeshingOptions &options) {
    return options.order == ElementOrder::Second;
}
bool verifies(const MeshingOptions &options) {
    return options.verify;
}

} // namespace

std::span<const Stage> stagesOfFront() {
    static constexpr std::array kStages = {Stage{StageTime::Mesh, frontStage, makesTriangles},
                                           Stage{StageTime::Mesh, quadFrontStage, makesQuads}};
    return kStages;
}

std::span<const Stage> stagesOfShapes() {
    constexpr std::size_t kOfShapes = 5; // before the mesh is joined to layers and rows
    return stagesAfterFront().first(kOfShapes);
}

std::span<const Stage> stagesAfterFront() {
    static constexpr std::array kStages = {Stage{StageTime::Improve, improveStage, improvesTriangles},
                                           Stage{StageTime::Improve, leastAngleStage, hasLeastAngle},
                                           Stage{StageTime::Mesh, blocksStage, makesTriangles},
                                           Stage{StageTime::Improve, quadCleanupStage, improvesQuads},
                                           Stage{StageTime::Mesh, quadBlocksStage, makesQuads},
                                           Stage{StageTime::Mesh, joinStage},
                                           Stage{StageTime::Mesh, orderStage, raisesOrder},
                                           Stage{StageTime::Mesh, periodicStage},
                                           Stage{StageTime::Mesh, cracksStage},
                                           Stage{StageTime::Improve, verifyStage, verifies}};
    return kStages;
}

Status runStages(std::span<const Stage> stages, MeshingState &state, const Progress &progress) {
    for (const Stage &stage : stages) {
        if (stage.applies != nullptr && !stage.applies(state.job.options)) {
            continue;
        }
        if (Status faults = stage.run(state, progress); hasErrors(faults)) {
            if (state.prepared.strips) { // their domain has other segments than the one given
                std::ranges::for_each(faults, [](Diagnostic &fault) { fault.parts.clear(); });
            }
            return faults;
        }
        if (progress.cancelled()) {
            return cancelled("meshing");
        }
    }
    return {};
}

Status blocksStage(MeshingState &state, const Progress &) {
    state.mesh = Mesh(std::move(state.triangles));
    return {};
}

} // namespace forefront
