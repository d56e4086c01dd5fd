#pragma once

#include "core/base/vec2.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A piece of a boundary with the domain to its left.
struct BoundaryPiece {
    Vec2 a;
    Vec2 b;
};

/// A box with the boundary pieces that run through it, which tell how much of it is domain. In floating point: for
/// estimates, where a piece that touches an edge or the centre of the box may be taken either way.
struct CoverageCell {
    Box2 box;
    bool centreInside = false;
    std::vector<std::uint32_t> pieces; ///< indices of all pieces that meet the box

    /// Area of the part that is domain, in [0, area of the box]; exact but for rounding.
    double coveredArea(std::span<const BoundaryPiece> all) const;

    /// One of its four quarters: bit 0 of k chooses the right half, bit 1 the upper one.
    CoverageCell quarter(unsigned k, std::span<const BoundaryPiece> all) const;
};

/// True if the closed segment meets the closed box.
bool meetsBox(const BoundaryPiece &piece, const Box2 &box);

/// The part of a piece within a box that it meets.
BoundaryPiece partWithin(const BoundaryPiece &piece, const Box2 &box);

} // namespace forefront
