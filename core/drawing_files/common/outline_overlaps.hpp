#pragma once

#include "core/drawing/arrangement/arrangement.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// The areas that two outlines enclose although neither contains the other.
struct OutlineOverlaps {
    std::size_t count = 0;    ///< number of areas
    double area = 0.0;        ///< their sum, in square domain units
    std::vector<Vec2> places; ///< inside the largest, at most ArrangementChange::kPlaces
    std::uint32_t first = 0;  ///< a piece of one of the outlines around the largest
    std::uint32_t second = 0; ///< a piece of the other
};

/// Finds outlines that overlap, among those of contours with the even-odd rule, where what both enclose is a hole.
/// `rings`: the first piece of each outline, ascending. Shared sides and outlines inside others are no overlaps.
OutlineOverlaps findOutlineOverlaps(const ArrangementInput &input, std::span<const std::uint32_t> rings);

/// Crossings of lines that bound the domain on both sides of a crossing, and so belong to two outlines.
struct OutlineCrossings {
    std::size_t count = 0;    ///< number of places
    std::vector<Vec2> places; ///< the first ones, at most ArrangementChange::kPlaces
    std::uint32_t first = 0;  ///< a piece of one of the lines that cross at the first place
    std::uint32_t second = 0; ///< a piece of the other
};

/// Finds the nodes at which two lines of the input cross and both go on as boundary.
OutlineCrossings findOutlineCrossings(const ArrangementInput &input, const Arrangement &arrangement);

} // namespace forefront
