#include "core/engine/mesh/outer_bulges.hpp"

#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/predicates.hpp"

#include <array>

namespace forefront {

namespace {

constexpr int kMaxHalvings = 10;

/// The control points of a part of an edge, whose convex hull contains it.
using BulgeHull = std::array<Vec2, 3>;

Box2 boxOfHull(const BulgeHull &hull) {
    Box2 box = boxOf(hull[0], hull[2]);
    box.add(hull[1]);
    return box;
}

/// Returns true if a line through two points of one hull has this hull on one side and the other hull on the other.
bool hasLineBetween(const BulgeHull &hull, const BulgeHull &other) {
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 a = hull[k], b = hull[(k + 1) % 3];
        if (a == b) {
            continue;
        }
        const int own = orientation(a, b, hull[(k + 2) % 3]);
        bool left = false, right = false;
        for (const Vec2 p : other) {
            const int side = orientation(a, b, p);
            left = left || side > 0;
            right = right || side < 0;
        }
        if ((own <= 0 && !right) || (own >= 0 && !left)) {
            return true;
        }
    }
    return false;
}

std::array<BulgeHull, 2> halvesOf(const BulgeHull &hull) {
    const Vec2 before = midpoint(hull[0], hull[1]), after = midpoint(hull[1], hull[2]);
    const Vec2 middle = midpoint(before, after);
    return {BulgeHull{hull[0], before, middle}, BulgeHull{middle, after, hull[2]}};
}

/// Returns true if two curves surely have no common points but their ends.
bool areApart(const BulgeHull &first, const BulgeHull &second, int halvings) {
    if (!boxOfHull(first).overlaps(boxOfHull(second)) || hasLineBetween(first, second) ||
        hasLineBetween(second, first)) {
        return true;
    }
    if (halvings == 0) {
        return false;
    }
    for (const BulgeHull &a : halvesOf(first)) {
        for (const BulgeHull &b : halvesOf(second)) {
            if (!areApart(a, b, halvings - 1)) {
                return false;
            }
        }
    }
    return true;
}

} // namespace

std::vector<std::uint32_t> meetingBulges(std::span<const OuterEdge> edges) {
    std::vector<BulgeHull> hulls;
    std::vector<Box2> boxes;
    for (const OuterEdge &edge : edges) {
        hulls.push_back({edge.start, edge.control, edge.end});
        boxes.push_back(boxOfHull(hulls.back()));
    }
    const BoxTree tree(boxes);
    std::vector<std::uint32_t> found;
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
        const auto misses = [&](std::uint32_t other) {
            return other == e || areApart(hulls[e], hulls[other], kMaxHalvings);
        };
        if (edges[e].bulges && !tree.search(boxes[e], misses)) {
            found.push_back(e);
        }
    }
    return found;
}

} // namespace forefront
