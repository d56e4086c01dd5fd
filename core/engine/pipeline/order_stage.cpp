#include "core/engine/base/cancelled.hpp"
#include "core/engine/layers/boundary_layers.hpp"
#include "core/engine/mesh/second_order.hpp"
#include "core/engine/pipeline/stages.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
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

/// Returns for each node whether it may move: those of boundary layers and of rows may not.
std::vector<bool> movableNodes(const MeshingState &state) {
    std::vector<bool> movable(state.mesh.nodes.size(), true);
    if (!state.prepared.layers) {
        return movable;
    }
    std::array<std::size_t, wordsOf<CellKind>().size()> fixed{}; // elements, the last ones of their blocks
    for (const LayerCell &cell : state.prepared.layers->cells) {
        ++fixed[static_cast<std::size_t>(cell.nodes[3] == kNoIndex ? CellKind::Triangle3 : CellKind::Quadrilateral4)];
    }
    for (const CellBlock &block : state.mesh.blocks) {
        for (std::size_t k = block.size() - fixed[static_cast<std::size_t>(block.kind())]; k < block.size(); ++k) {
            for (const NodeId node : block.nodesOf(k)) {
                movable[index(node)] = false;
            }
        }
    }
    return movable;
}

} // namespace

Status orderStage(MeshingState &state, const Progress &progress) {
    const std::vector<std::size_t> chords = crossingChords(*state.prepared.boundary);
    const MeshingOptions &options = state.job.options;
    std::vector<bool> movable;
    if (options.improve != ImproveLevel::None) {
        movable = movableNodes(state);
    }
    if (!raiseOrder(state.mesh, {options.quadNodes, chords, movable.empty() ? nullptr : &movable}, state.secondOrder,
                    progress)) {
        return cancelled("meshing");
    }
    return {};
}

} // namespace forefront
