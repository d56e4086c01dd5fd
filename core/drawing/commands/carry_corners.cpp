#include "core/drawing/commands/carry_corners.hpp"

#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// A place that a node has left, and where it is now.
struct MovedNode {
    Vec2 from, to;
};

/// Returns the nodes that have moved, of shapes that have the same nodes as before.
std::vector<MovedNode> movedNodes(const Document &before, const Document &after) {
    std::vector<MovedNode> moved;
    for (const auto &now : after.shapes) {
        const std::size_t at = positionOf(before, now->id);
        if (at == before.shapes.size() || before.shapes[at] == now || !canJoin(*now)) {
            continue;
        }
        const Shape &old = *before.shapes[at];
        if (!canJoin(old) || handleCount(old) != handleCount(*now) || hasReorderedHandles(old, *now)) {
            continue;
        }
        const std::vector<Vec2> from = handlesOf(old), to = handlesOf(*now);
        for (std::size_t k = 0; k < from.size(); ++k) {
            if (from[k] != to[k]) {
                moved.push_back({from[k], to[k]});
            }
        }
    }
    return moved;
}

} // namespace

Document carryCorners(const Document &before, Document after, double tolerance) {
    if (after.mapped.empty()) {
        return after;
    }
    const std::vector<MovedNode> moved = movedNodes(before, after);
    for (MappedSpec &spec : after.mapped) {
        if (std::ranges::find(before.mapped, spec) == before.mapped.end()) {
            continue;
        }
        for (Vec2 &corner : spec.corners) {
            const auto node = std::ranges::find_if(
                moved, [&](const MovedNode &place) { return distance(place.from, corner) <= tolerance; });
            corner = node != moved.end() ? node->to : corner;
        }
    }
    return after;
}

} // namespace forefront
