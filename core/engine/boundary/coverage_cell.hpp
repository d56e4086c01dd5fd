#pragma once

#include "core/engine/base/vec2.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A boundary piece with the domain to its left.
struct BoundaryPiece {
    Vec2 a;
    Vec2 b;
};

/// A box with the boundary pieces that cross it, for computing how much of its area lies inside the domain. Uses
/// floating point, for estimates: a piece that touches an edge or the centre of the box may count either way.
struct CoverageCell {
    Box2 box;
    bool centreInside = false;
    std::vector<std::uint32_t> pieces; ///< indices of all pieces that meet the box

    /// Returns the area of the part inside the domain, in [0, area of the box], up to rounding.
    double coveredArea(std::span<const BoundaryPiece> all) const;

    /// Returns the quarters: bit 0 of their index selects the right half, bit 1 the upper half.
    std::array<CoverageCell, 4> quarters(std::span<const BoundaryPiece> all) const;
};

/// Returns true if the closed segment meets the closed box.
bool meetsBox(const BoundaryPiece &piece, const Box2 &box);

/// Returns the part of a piece within a box that it meets.
BoundaryPiece partWithin(const BoundaryPiece &piece, const Box2 &box);

} // namespace forefront
