#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/quads/quad_cell.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace forefront {

/// The elements that fill a polygon.
struct PolygonFill {
    std::vector<QuadCell> cells; ///< of indices of the polygon's nodes
    std::size_t triangles = 0;
    double leastShape = 2.0; ///< minimum scaled Jacobian
};

/// What the fill of a polygon may be made of.
struct FillRules {
    /// Returns true if no edge may join two nodes, given by their indices.
    std::function<bool(std::size_t, std::size_t)> forbids;
    double triangleCost = 0.0; ///< in those of a quadrilateral with a scaled Jacobian of 1/2
};

/// Returns true unless an element has a corner that is flat or reflex within rounding; of a quadrilateral, also a
/// corner with a sine below 1e-9.
bool isClearlyConvex(const QuadCell &cell, std::span<const Vec2> nodes);

/// The greatest number of nodes that fillPolygon() takes: its work grows with their fourth power.
inline constexpr std::size_t kMaxFillNodes = 64;

/// Fills a simple polygon with strictly convex quadrilaterals and triangles without new nodes, at the least cost of all
/// fills. Nodes are given counter-clockwise. Returns nothing if the polygon is not simple by exact predicates, is
/// clockwise, has more than kMaxFillNodes nodes, or if the rules leave no fill.
std::optional<PolygonFill> fillPolygon(std::span<const Vec2> nodes, const FillRules &rules);

} // namespace forefront
