#pragma once

#include "core/edit/pick_index.hpp"

#include <optional>

namespace forefront {

/// What a point was drawn to.
enum class SnapKind : std::uint8_t {
    None,
    Node,
    Segment,
    Grid,
    Angle, ///< a ray from the anchor at a multiple of 15 degrees
    Locked ///< a typed or locked coordinate
};

/// Coordinates held fixed while drawing, as typed: each that is set takes away freedom before anything snaps.
struct SnapLocks {
    std::optional<double> x, y;
    std::optional<double> distance; ///< from the anchor, > 0
    std::optional<double> angle;    ///< of the direction from the anchor, degrees counter-clockwise from +x

    bool any() const { return x || y || distance || angle; }
};

struct SnapQuery {
    Vec2 at;                    ///< the pointer, in domain units
    double tolerance = 0.0;     ///< reach of nodes and segments, domain units
    double gridPitch = 0.0;     ///< 0: no grid
    std::optional<Vec2> anchor; ///< the last node drawn, or where a drag began
    bool off = false;           ///< ctrl: nothing snaps (locks still hold)
    bool angle = false;         ///< shift: directions from the anchor in steps of 15 degrees
    SnapLocks locks;
    PickIndex::Filter filter; ///< shapes to snap to; empty: all
};

struct Snapped {
    Vec2 at;
    SnapKind kind = SnapKind::None;
    std::optional<SegmentHit> segment; ///< where kind is Segment
};

/// Where a point goes: to an angle, node, segment or the grid, in this order; what is locked holds. The grid is weak:
/// it draws to its nearest crossing within the tolerance only.
Snapped snap(const PickIndex &index, const SnapQuery &query);

/// Pitch of the drawing grid: 1, 2 or 5 times a power of ten, so that lines are at least `leastPixels` apart.
double gridPitch(double unitsPerPixel, double leastPixels = 18.0);

inline constexpr double kSnapAngle = 15.0; ///< degrees

} // namespace forefront
