#include "core/engine/pipeline/stages.hpp"

#include "core/engine/base/cancelled.hpp"

#include <array>
#include <utility>

namespace forefront {

std::span<const Stage> stagesBeforeFront() {
    static constexpr std::array kStages = {Stage{StageTime::Prepare, validateStage},
                                           Stage{StageTime::Prepare, spacingStage},
                                           Stage{StageTime::Prepare, boundaryStage}};
    return kStages;
}

std::span<const Stage> stagesOfFront() {
    static constexpr std::array kStages = {Stage{StageTime::Mesh, frontStage}};
    return kStages;
}

namespace {

bool improves(const MeshingOptions &options) {
    return options.improve != ImproveLevel::None;
}
bool verifies(const MeshingOptions &options) {
    return options.verify;
}

} // namespace

std::span<const Stage> stagesAfterFront() {
    static constexpr std::array kStages = {Stage{StageTime::Improve, improveStage, improves},
                                           Stage{StageTime::Mesh, blocksStage},
                                           Stage{StageTime::Improve, verifyStage, verifies}};
    return kStages;
}

Status runStages(std::span<const Stage> stages, MeshingState &state, const Progress &progress) {
    for (const Stage &stage : stages) {
        if (stage.applies != nullptr && !stage.applies(state.job.options)) {
            continue;
        }
        if (Status faults = stage.run(state, progress); hasErrors(faults)) {
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
