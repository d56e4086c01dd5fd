#include "core/engine/base/cancelled.hpp"
#include "core/engine/mesh/second_order.hpp"
#include "core/engine/pipeline/stages.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace forefront {

namespace {

/// Returns the tagged edges that stay chords, since their curves cross there.
std::vector<std::size_t> crossingChords(const DiscreteDomain &boundary) {
    std::vector<std::uint32_t> crossing = boundary.straightened;
    std::ranges::sort(crossing);
    std::vector<std::size_t> chords;
    for (std::size_t i = 0; !crossing.empty() && i < boundary.segments.size(); ++i) {
        if (std::ranges::binary_search(crossing, boundary.segments[i].source)) {
            chords.push_back(i);
        }
    }
    return chords;
}

} // namespace

Status orderStage(MeshingState &state, const Progress &progress) {
    const std::vector<std::size_t> chords = crossingChords(*state.prepared.boundary);
    if (!raiseOrder(state.mesh, state.job.options.quadNodes, chords, state.secondOrder, progress)) {
        return cancelled("meshing");
    }
    return {};
}

} // namespace forefront
