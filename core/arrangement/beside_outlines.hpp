#pragma once

#include "core/geometry/curve.hpp"
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

/// Properties of an edge that decide whether lines repeat outlines.
struct BesideEdge {
    BesideRole role = BesideRole::Dropped;
    double reach = 0.0;        ///< of a LooseLine: how far from outlines it may run
    bool divides = true;       ///< its sides are different faces
    CurveStretch stretch = {}; ///< the part of a curve that it is a chord of, from its end `a` to its end `b`
};

/// An edge that repeats outlines.
struct RepeatingEdge {
    std::uint32_t edge = 0;
    double distance = 0.0; ///< from the outlines, the maximum at five places along it
};

/// Finds the loose lines that repeat outlines: chains of them, from one node where they meet anything else to the next,
/// that stay within their reach of outlines on one side, and whose length is at least four times that distance. Where
/// another line that divides two faces ends on such a chain, the chain stays, or the shortest one that leads from there
/// to an outline. `about`: per edge.
std::vector<RepeatingEdge> edgesRepeatingOutlines(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges,
                                                  std::span<const BesideEdge> about, std::span<const Curve> curves);

} // namespace forefront
