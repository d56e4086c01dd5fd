#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/geometry/plane_sweep.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace forefront {

/// A straight line between two places; a point if they are the same.
struct SnapLine {
    Vec2 a;
    Vec2 b;
};

/// A place on a line that joining must not move far: at a fraction of the way from the end that comes first by x, then
/// y.
struct LinePin {
    SnapLine line; ///< from that end
    double part = 0.0;
};

/// Nodes and edges that keep a distance from each other, and the path of each line along them.
struct SnappedLines {
    std::vector<Vec2> nodes;
    std::vector<std::uint8_t> crossing; ///< per node: true if it is a crossing and not the end of a line
    std::vector<PlaneEdge> edges;
    std::vector<std::uint32_t> starts; ///< per line: where its path begins in `ways`; then the size of `ways`
    std::vector<std::uint32_t> ways;   ///< 2e: along edge e from a to b; 2e + 1: back
    std::vector<std::uint32_t> first;  ///< per line: the node that its first end became
    double radius = 0.0;               ///< maximum distance at which things were joined
    std::vector<LinePin> pins;         ///< places where lines were held, since they would have been moved too far
    double displacement = 0.0;         ///< maximum distance between a line and its path
    std::size_t passes = 0;            ///< number of times all lines were joined; a measure of the work
    bool finished = true;              ///< false if asked to stop
};

/// Returns the minimum tolerance for lines within a box: a few units in the last place of the coordinates. With a
/// smaller one, rounding could reverse the order of nodes and edges.
double resolutionOf(const Box2 &box);

/// Returns the lines unchanged, except that ends with equal coordinates and repeated lines are merged.
SnappedLines unsnapped(std::span<const SnapLine> lines);

/// Joins everything closer than the tolerance (positive) and moves nothing farther than that. Afterwards all nodes are
/// farther than `radius` from one another, edges meet only at common ends, and no node is within the radius of the
/// interior of an edge, except where routing the edge through it would make a part longer than the edge. So joining
/// again with that radius changes nothing. The radius is the tolerance, but where several things are crowded within it
/// so that steps add up to more than the tolerance, it is halved until they do not.
///
/// Ends of lines become nodes unchanged; of several within the radius, the first by x, then y, becomes a node, and the
/// others move onto it (as snap rounding does with the pixels of a grid: J. Hershberger, Stable snap rounding, 2013).
/// Then edges near a node are routed through it, and crossing edges get a node, until nothing is left to do. This ends,
/// since nodes keep apart and edges only get shorter. O(n log n) for the usual few rounds.
SnappedLines snapLines(std::span<const SnapLine> lines, double tolerance, const std::stop_token &stop = {});
/// Does the same for lines most of which have been joined before, and begins with the radius and the pins found then,
/// which saves passes. Pins that are no longer needed may leave nodes on lines.
SnappedLines snapLines(std::span<const SnapLine> lines, double tolerance, const SnappedLines &before,
                       const std::stop_token &stop);

} // namespace forefront
