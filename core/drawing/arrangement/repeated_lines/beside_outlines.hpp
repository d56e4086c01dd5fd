#pragma once

#include "core/engine/geometry/curve.hpp"
#include "core/engine/geometry/plane_sweep.hpp"

#include <cstdint>
#include <optional>
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

/// An edge that repeats outlines, at least in part.
struct RepeatingEdge {
    std::uint32_t edge = 0;
    double distance = 0.0; ///< from the outlines, the maximum at the places where it was measured
};

/// A part that stays of an edge that repeats outlines elsewhere, or that meets such an edge.
struct RemainingPart {
    std::uint32_t edge = 0;
    double from = 0.0, to = 1.0;    ///< fractions of the way from its end `a`, along its curve by the parameter
    std::optional<Vec2> begin, end; ///< the places on outlines that its ends have to move to
};

/// The edges that repeat outlines, and the remaining parts of their lines.
struct RepeatedOutlines {
    std::vector<RepeatingEdge> edges;
    std::vector<RemainingPart> parts; ///< by edges, and then by fractions
};

/// Finds the loose lines that repeat outlines. They are searched in chains, from one node where they meet anything else
/// to the next.
/// - A chain repeats outlines as a whole if it stays within its reach of them on one side, and its length is at least
///   four times that distance.
/// - A part of a chain does so if it is long for its distance, see kMinRunToDistance. It ends where the line turns
/// away.
/// - Where another loose line goes on from a part that is dropped, its end moves to the outline.
/// - Where a line that must stay and divides two faces ends on a chain, the chain stays, or the shortest one that leads
///   from there to an outline.
/// `about`: per edge.
RepeatedOutlines findRepeatedOutlines(std::span<const Vec2> nodes, std::span<const PlaneEdge> edges,
                                      std::span<const BesideEdge> about, std::span<const Curve> curves);

} // namespace forefront
