#pragma once

#include "core/base/vec2.hpp"
#include "core/domain/domain.hpp"

#include <cstddef>

namespace forefront {

/// Makes lines that form closed loops part of the boundary of a domain. Returns the number of segments that became
/// boundary: 0 if the lines enclose nothing. Some programs export outlines as separate lines, and without this such a
/// domain would be refused, or a hole in it meshed instead. Inside and outside follow the even-odd rule; where three or
/// more lines meet at a node, the outermost ones become boundary and the others stay constraints. If the domain has a
/// boundary already, lines inside it stay constraints, except for loops that touch nothing else. No two segments may
/// cross.
std::size_t takeLinesAsOutline(Domain &domain);

/// Ends of lines outside the boundary that nearly meet. Lengths are in domain units.
struct LineGaps {
    std::size_t count = 0;   ///< number of ends
    double widest = 0.0;     ///< maximum distance to the nearest other end
    Vec2 first;              ///< the first of the ends
    std::size_t segment = 0; ///< the segment that ends there
};

/// Finds the free ends of lines outside the boundary within `limit` (domain units) of another such end.
LineGaps findLineGaps(const Domain &domain, double limit);

} // namespace forefront
