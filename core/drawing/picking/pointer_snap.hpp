#pragma once

#include "core/drawing/picking/inference.hpp"
#include "core/drawing/picking/pick_index.hpp"

#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// The kind of target that a point snapped to.
enum class SnapKind : std::uint8_t {
    None,
    Node,
    Midpoint,      ///< of a segment, by its parameter
    Centre,        ///< of a circle, an ellipse, an arc or a rectangle
    Intersection,  ///< of segments
    Perpendicular, ///< where a line from the anchor meets a segment at a right angle
    Tangent,       ///< where a line from the anchor touches a curve
    Segment,
    Guide, ///< a guide of the document, or the crossing of two
    Grid,
    Angle,   ///< a ray from the anchor at a multiple of the angle step
    Locked,  ///< a typed or locked coordinate
    Inferred ///< a relation to other lines or nodes, see inferRelations()
};

inline constexpr double kSnapAngle = 15.0; ///< default step of directions, degrees

/// Coordinates fixed by typing while drawing. They are applied before anything snaps.
struct SnapLocks {
    std::optional<double> x, y;
    std::optional<double> distance; ///< from the anchor, > 0
    std::optional<double> angle;    ///< of the direction from the anchor, degrees counter-clockwise from +x
    bool isRadius = false;          ///< `distance` is called a radius, not a length

    bool any() const { return x || y || distance || angle; }
};

/// A point to snap and the rules for it.
struct SnapQuery {
    Vec2 at;                       ///< the pointer, in domain units
    double tolerance = 0.0;        ///< snapping distance of nodes and segments, domain units
    double gridPitch = 0.0;        ///< 0: no grid; else what meets nothing nearer lies on the grid
    std::optional<Vec2> anchor;    ///< the last node drawn, or the start of a drag
    std::vector<Vec2> lines;       ///< starts of straight lines to the point: perpendiculars and tangents count
    bool off = false;              ///< ctrl: nothing snaps, but locks apply
    bool angle = false;            ///< shift: directions from the anchor in steps
    double angleStep = kSnapAngle; ///< of these steps, degrees, > 0
    SnapLocks locks;
    bool guides = true;                    ///< snap to the guides of the document
    PickIndex::Filter filter;              ///< items to snap to
    std::optional<InferenceQuery> infer{}; ///< none: nothing is inferred
};

/// The result of snapping.
struct Snapped {
    Vec2 at;
    SnapKind kind = SnapKind::None;
    std::optional<SegmentHit> segment{}; ///< set if kind is Segment
    /// The start of the line that is perpendicular, tangent or at an angle, or that has a locked length or angle.
    std::optional<Vec2> from{};
    double degrees = 0.0; ///< of the direction in [0, 360), if kind is Angle
    SnapLocks locks{};    ///< set if kind is Locked
    /// The relations that the point fulfils, at most one of a line or length and one of its place, or two of its place.
    std::vector<Inference> inferred{};
    SnapKind within = SnapKind::None; ///< what a point with some coordinates locked snapped to with the others
};

/// Returns a point of which both coordinates are typed.
Snapped lockedAt(Vec2 place);

/// Describes the snap target of a point in a few words, such as "midpoint", "angle 45°" or "x locked, node"; empty if
/// it did not snap.
std::string wordsOf(const Snapped &snapped);

/// Snaps a point to an angle, node, special point (see specialPoint()), segment or guide, in this order of preference,
/// else to inferred relations or to the grid, whichever is nearer, within the locks. With a grid, what may slide along
/// an upright or level segment, guide or relation has its other coordinate on the grid. Beside a locked distance or
/// angle the grid attracts only near its points. Relations that a snapped point fulfils are told, too.
Snapped snap(const PickIndex &index, const SnapQuery &query);

/// Returns the pitch of the drawing grid: 1, 2 or 5 times a power of ten, with lines at least `minPixels` apart; 0 if
/// `unitsPerPixel` is not a positive number.
double gridPitch(double unitsPerPixel, double minPixels = 18.0);

/// Returns the pitch of a drawing grid with a chosen step; while the lines of that would be less than 6 pixels apart,
/// the step times 2, 5, 10, 20 and so on. 0: see gridPitch().
double steppedPitch(double step, double unitsPerPixel);

} // namespace forefront
