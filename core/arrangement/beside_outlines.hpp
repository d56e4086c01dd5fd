#pragma once

#include "core/geometry/plane_sweep.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// The role of an edge in the search for lines that repeat outlines.
enum class BesideRole : std::uint8_t {
    Dropped, ///< does not count
    Outline,
    Line,     ///< a line that must stay
    LooseLine ///< a line that may be dropped
};

/// A line that runs along outlines.
struct BesideEdge {
    std::uint32_t edge = 0;
    double distance = 0.0; ///< its maximum distance from the outlines
};

/// Finds the loose lines that repeat outlines: chains of them, from one node where they meet anything else to the next,
/// all of whose points are within their reach of outlines. `reach`: per edge; unused unless it is a LooseLine.
std::vector<BesideEdge> edgesBesideOutlines(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges,
                                            std::span<const BesideRole> roles, std::span<const double> reach);

} // namespace forefront
