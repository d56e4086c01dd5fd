#pragma once

#include "core/geometry/plane_sweep.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

enum class BesideRole : std::uint8_t {
    Dropped, ///< does not count
    Outline,
    Line,     ///< a line that must stay
    LooseLine ///< a line that may be dropped
};

/// What the search for lines that repeat outlines needs to know of an edge.
struct BesideEdge {
    BesideRole role = BesideRole::Dropped;
    double reach = 0.0;     ///< of a LooseLine: how far from outlines it may run
    double deviation = 0.0; ///< maximum distance of the edge from the curve that it follows
    bool divides = true;    ///< its sides are different faces
};

/// An edge that repeats outlines.
struct RepeatingEdge {
    std::uint32_t edge = 0;
    double distance = 0.0; ///< from the outlines, the largest of those at its ends and its middle
};

/// Finds the loose lines that repeat outlines: chains of them, from one node where they meet anything else to the next,
/// all of whose points are within their reach of outlines, and that are at least four times as long as they are far
/// away.
/// No line that divides two faces gets a loose end: the chains at such an end stay. `about`: per edge.
std::vector<RepeatingEdge> edgesRepeatingOutlines(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges,
                                                  std::span<const BesideEdge> about);

} // namespace forefront
