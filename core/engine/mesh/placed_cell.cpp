#include "core/engine/mesh/placed_cell.hpp"

#include "core/engine/geometry/curve.hpp"
#include "core/engine/geometry/flat.hpp"
#include "core/engine/mesh/jacobian.hpp"
#include "core/engine/mesh/quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace forefront {

namespace {

bool isSame(Vec2 a, Vec2 b, double margin) {
    return std::abs(a.x - b.x) <= margin && std::abs(a.y - b.y) <= margin;
}

Vec2 meanOfCorners(const PlacedCell &cell) {
    Vec2 sum;
    for (const Vec2 corner : cell.corners()) {
        sum += corner;
    }
    return (1.0 / static_cast<double>(cell.corners().size())) * sum;
}

/// Returns the scaled Jacobian of the polygon of the corners.
double scaledJacobianOfCorners(const PlacedCell &cell) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < cell.corners().size(); ++k) {
        const Vec2 ahead = cell.cornerAfter(k) - cell.nodes[k], back = cell.cornerBefore(k) - cell.nodes[k];
        const double lengths = length(ahead) * length(back);
        least = std::min(least, lengths > 0.0 ? cross(ahead, back) / lengths : 0.0);
    }
    constexpr double kEquilateral = 2.0 / std::numbers::sqrt3; // 1 over the sine of its angles
    return cell.traits().corners == 3 ? kEquilateral * least : least;
}

} // namespace

bool isMiddleOfChord(Vec2 a, Vec2 b, Vec2 middle) {
    Box2 box = boxOf(a, b);
    return isSame(midpoint(a, b), middle, roundingMargin(box));
}

bool PlacedCell::isStraight() const {
    if (traits().order == 1) {
        return true;
    }
    for (std::size_t k = 0; k < corners().size(); ++k) {
        if (!isMiddleOfChord(nodes[k], cornerAfter(k), middle(k))) {
            return false;
        }
    }
    if (kind != CellKind::Quadrilateral9) {
        return true;
    }
    Box2 box = boxOf(nodes[0], nodes[2]);
    box.add(nodes[1]);
    box.add(nodes[3]);
    return isSame(meanOfCorners(*this), nodes[8], roundingMargin(box));
}

Vec2 PlacedCell::centre() const {
    switch (kind) {
    case CellKind::Triangle6:
        return (1.0 / 9.0) * (4.0 * (nodes[3] + nodes[4] + nodes[5]) - (nodes[0] + nodes[1] + nodes[2]));
    case CellKind::Quadrilateral8:
        return 0.5 * (nodes[4] + nodes[5] + nodes[6] + nodes[7]) - meanOfCorners(*this);
    case CellKind::Quadrilateral9:
        return nodes[8];
    case CellKind::Triangle3:
        return (1.0 / 3.0) * (nodes[0] + nodes[1] + nodes[2]);
    default:
        return meanOfCorners(*this);
    }
}

double edgeLength(std::span<const Vec2> nodes, NodeId a, NodeId middle, NodeId b) {
    const Vec2 from = nodes[index(a)], to = nodes[index(b)];
    if (middle == kNoNode || isMiddleOfChord(from, to, nodes[index(middle)])) {
        return distance(from, to);
    }
    return Curve::quadratic(from, 2.0 * nodes[index(middle)] - 0.5 * (from + to), to).length();
}

double twiceArea(const PlacedCell &cell) {
    const auto &n = cell.nodes;
    // Of a quadrilateral, half the cross product of its diagonals.
    double twice = cell.traits().corners == 3 ? cross(n[1] - n[0], n[2] - n[0]) : cross(n[2] - n[0], n[3] - n[1]);
    if (cell.traits().order == 2) {
        // Between a parabola and its chord lie two thirds of the triangle that has the middle node as its tip, twice.
        for (std::size_t k = 0; k < cell.corners().size(); ++k) {
            const Vec2 a = n[k];
            twice -= 4.0 / 3.0 * cross(cell.cornerAfter(k) - a, cell.middle(k) - a);
        }
    }
    return twice;
}

double shapeFactor(const PlacedCell &cell) {
    const auto &n = cell.nodes;
    if (cell.traits().corners == 3) {
        return shapeFactor(n[0], n[1], n[2]);
    }
    constexpr double kHalfSquare = 2.0 / std::numbers::sqrt3; // 1 over the α of half a square
    return kHalfSquare * std::min({shapeFactor(n[3], n[0], n[1]), shapeFactor(n[0], n[1], n[2]),
                                   shapeFactor(n[1], n[2], n[3]), shapeFactor(n[2], n[3], n[0])});
}

AngleRange anglesOf(const PlacedCell &cell) {
    AngleRange range{180.0, 0.0};
    for (std::size_t k = 0; k < cell.corners().size(); ++k) {
        const Vec2 ahead = cell.cornerAfter(k) - cell.nodes[k], back = cell.cornerBefore(k) - cell.nodes[k];
        const double turn = cross(ahead, back);
        if (!(turn > 0.0)) {
            return {0.0, 180.0};
        }
        const double angle = std::atan2(turn, dot(ahead, back)) * 180.0 / std::numbers::pi;
        range.smallest = std::min(range.smallest, angle);
        range.largest = std::max(range.largest, angle);
    }
    return range;
}

double aspectRatio(const PlacedCell &cell) {
    const auto &n = cell.nodes;
    constexpr double kFlat = std::numeric_limits<double>::infinity();
    if (cell.traits().corners == 3) {
        const double longest =
            std::max({distanceSquared(n[0], n[1]), distanceSquared(n[1], n[2]), distanceSquared(n[2], n[0])});
        const double twice = std::abs(cross(n[1] - n[0], n[2] - n[0]));
        return twice > 0.0 ? 0.5 * std::numbers::sqrt3 * longest / twice : kFlat;
    }
    const auto [shorter, longer] = std::minmax(
        {distance(midpoint(n[0], n[1]), midpoint(n[2], n[3])), distance(midpoint(n[1], n[2]), midpoint(n[3], n[0]))});
    return shorter > 0.0 ? longer / shorter : kFlat;
}

double scaledJacobian(const PlacedCell &cell) {
    const double ofCorners = scaledJacobianOfCorners(cell);
    if (!(ofCorners > 0.0) || cell.isStraight()) {
        return ofCorners;
    }
    return ofCorners * std::min(1.0, leastJacobianRatio(cell));
}

} // namespace forefront
