#pragma once

#include "core/engine/base/vec2.hpp"

#include <cmath>
#include <limits>

namespace forefront {

/// Returns true unless the triangle abc is counter-clockwise by more than rounding can explain: its nodes may just as
/// well lie on a line, or be clockwise.
///
/// Where each coordinate x carries up to k roundings, hence an error of k·u·X with X = max |x| and u = 2⁻⁵³, twice the
/// area errs by at most Σ |δx|·|Δy| + |δy|·|Δx| over the nodes and the sides opposite. In a box of w by h the sides
/// of a triangle rise by 2h in all and run over 2w, so this is at most 2·k·u·(X·h + Y·w). The differences, products
/// and difference below add at most 4·u·2·w·h, and w ≤ 2X, h ≤ 2Y. Nodes that were interpolated carry k = 4 roundings,
/// which makes 8 units in the last place (2u each) in total. `margin`: a multiple of this bound that counts.
inline bool isFlat(Vec2 a, Vec2 b, Vec2 c, double margin = 1.0) {
    constexpr double kUnits = 8.0 * std::numeric_limits<double>::epsilon();
    Box2 box = boxOf(a, b);
    box.add(c);
    const double maxX = std::max(std::fabs(box.min.x), std::fabs(box.max.x));
    const double maxY = std::max(std::fabs(box.min.y), std::fabs(box.max.y));
    const Vec2 size = box.size();
    return !(cross(b - a, c - a) > margin * kUnits * (maxX * size.y + maxY * size.x));
}

/// The multiple of the bound of isFlat() within which the mesher avoids flat elements and sides that touch a node. More
/// than 1, since the bound of an element beside a side differs slightly from the bound of the side and the node.
inline constexpr double kAvoidedFlatness = 4.0;

/// Returns the margin of a box that reaches all points whose coordinates may be inside it but for their rounding.
inline double roundingMargin(const Box2 &box) {
    constexpr double kUnits = kAvoidedFlatness * 16.0 * std::numeric_limits<double>::epsilon();
    return kUnits * std::max(std::max(std::fabs(box.min.x), std::fabs(box.max.x)),
                             std::max(std::fabs(box.min.y), std::fabs(box.max.y)));
}

/// Returns true if p lies on the segment ab or so close to it that rounding cannot tell on which side.
inline bool nearlyOnSegment(Vec2 a, Vec2 b, Vec2 p) {
    const Box2 box = boxOf(a, b);
    return box.grown(roundingMargin(box)).contains(p) && isFlat(a, b, p, kAvoidedFlatness) &&
           isFlat(b, a, p, kAvoidedFlatness);
}

} // namespace forefront
