#include "core/engine/domain/inside_test.hpp"

#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <utility>

namespace forefront {
namespace {

/// Returns true if two segments have a point in common; exact.
bool segmentsMeet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    if (!boxOf(a, b).overlaps(boxOf(c, d))) {
        return false;
    }
    const auto sidesDiffer = [](int one, int other) { return one * other <= 0; };
    return sidesDiffer(orientation(a, b, c), orientation(a, b, d)) &&
           sidesDiffer(orientation(c, d, a), orientation(c, d, b));
}

} // namespace

InsideTest::InsideTest(const DomainFaces &found) {
    const auto &[graph, sweep, faces, labels] = found;
    std::vector<Box2> boxes;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        if (labels.inside[faces.left[e]] != labels.inside[faces.right[e]]) {
            Wall wall{graph.points[graph.edges[e].a], graph.points[graph.edges[e].b]};
            if (wall.b.x < wall.a.x) {
                std::swap(wall.a, wall.b);
            }
            walls_.push_back(wall);
            boxes.push_back(boxOf(wall.a, wall.b));
        }
    }
    tree_ = BoxTree(boxes);
}

bool InsideTest::contains(Vec2 p) const {
    const auto meetsRay = [&](const Box2 &box) { return box.min.x <= p.x && p.x <= box.max.x && box.max.y >= p.y; };
    bool inside = false; // changes at each wall above p
    const bool apart = tree_.search(meetsRay, [&](std::uint32_t item) {
        const Wall &wall = walls_[item];
        const int side = orientation(wall.a, wall.b, p);
        if (side == 0 && boxOf(wall.a, wall.b).contains(p)) {
            return false; // on the boundary
        }
        if (side < 0 && wall.a.x <= p.x && p.x < wall.b.x) {
            inside = !inside;
        }
        return true;
    });
    return inside || !apart;
}

bool InsideTest::boundaryMeets(const Box2 &box) const {
    const auto misses = [&](std::uint32_t item) {
        const Wall &wall = walls_[item];
        const Vec2 along = wall.b - wall.a, half = 0.5 * box.size();
        const double side = cross(along, box.centre() - wall.a);
        return std::abs(side) > half.x * std::abs(along.y) + half.y * std::abs(along.x);
    };
    return !tree_.search(box, misses);
}

bool InsideTest::boundaryCrosses(Vec2 a, Vec2 b) const {
    return !tree_.search(boxOf(a, b),
                         [&](std::uint32_t item) { return !segmentsMeet(a, b, walls_[item].a, walls_[item].b); });
}

} // namespace forefront
