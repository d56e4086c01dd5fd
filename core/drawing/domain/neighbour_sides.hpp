#pragma once

#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// The segments of a closed boundary in a domain, in order: from `first` to before `end`.
struct DrawnLoop {
    std::uint32_t first = 0, end = 0;
};

/// A border of two closed boundaries that lie beside each other, which both of them have drawn.
struct NeighbourSide {
    std::uint32_t kept = 0, dropped = 0; ///< indices of segments
};

/// Returns the straight segments that two loops have in common, with the areas of the loops on opposite sides. What
/// more than two loops share, and what lies on one side of both, is left out; so are chords of curves, whose nodes
/// differ by rounding. In the order of the dropped segments.
std::vector<NeighbourSide> neighbourSides(const Domain &domain, std::span<const DrawnLoop> loops);

} // namespace forefront
