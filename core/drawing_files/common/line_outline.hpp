#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/domain/domain.hpp"

#include <cstddef>
#include <vector>

namespace forefront {

/// The result of making closed loops of lines part of the boundary.
struct LineLoops {
    std::size_t segments = 0;  ///< number of segments that became boundary
    std::size_t left = 0;      ///< number of loops that stayed lines
    std::size_t firstLeft = 0; ///< a segment of the first of them
};

/// Makes lines that form closed loops part of the boundary of a domain. Some programs export outlines as separate
/// lines, and without this such a domain would be refused, or a hole in it meshed instead. Inside and outside follow
/// the even-odd rule; where three or more lines meet at a node, the outermost ones become boundary and the others stay
/// constraints. If the domain has a boundary already, only two kinds of loops become boundary: those that touch nothing
/// else, and lines around outlines whose outermost ones cross nothing. Others may be centre lines, axes or dimension
/// lines. No two segments may cross.
LineLoops takeLinesAsOutline(Domain &domain);

/// Ends of lines within this fraction of the diagonal of each other may be meant to meet.
inline constexpr double kNearEnds = 0.01;

/// A free end of a line that nearly meets another.
struct NearEnd {
    Vec2 at;
    double gap = 0.0;        ///< distance to the nearest other end, in domain units
    std::size_t segment = 0; ///< the segment that ends there
};

/// Free ends of lines that nearly meet. Lengths are in domain units.
struct LineGaps {
    std::size_t count = 0; ///< number of ends
    double widest = 0.0;   ///< maximum distance to the nearest other end
    std::vector<NearEnd> ends;
};

/// Finds the free ends of lines within `limit` (domain units) of another such end.
LineGaps findLineGaps(const Domain &domain, double limit);

} // namespace forefront
