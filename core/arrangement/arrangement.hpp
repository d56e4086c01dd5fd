#pragma once

#include "core/arrangement/change.hpp"
#include "core/arrangement/overlap_rule.hpp"
#include "core/base/result.hpp"
#include "core/domain/domain.hpp"

#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

// From the lines that a file holds to a domain that can be meshed.
//
// Why no library does this. Measured against what is needed (labels on every piece of boundary, results that depend on
// nothing but the geometry, no vertex moved without reason, a permissive licence):
// - GEOS 3.11 (LGPL): overlays two geometries at a time and rounds every vertex to a grid when given a precision; the
//   noder that keeps labels is internal C++ without a stable interface; no winding numbers.
// - CGAL 5.5: Snap_rounding_2 and Arrangement_2 do most of it, but are GPL, and snap rounding moves every vertex.
// - Boost.Polygon (Boost licence): integer coordinates of 32 bits, and the sets it returns carry no labels.
// - Clipper 6 (Boost licence): integer coordinates, closed paths without labels, no faces.
// What the core has already (exact predicates, plane sweep, faces) is the larger half of the work.

namespace forefront {

/// What a piece of a drawing means.
enum class PieceRole : std::uint8_t {
    Outline,    ///< part of a contour: counts for inside and outside
    Constraint, ///< a line that the mesh must contain
    Point       ///< a node that the mesh must contain; both ends are the same
};

/// A straight piece of a drawing with its labels.
struct ArrangementPiece {
    Vec2 a;
    Vec2 b;
    std::uint32_t contour = 0; ///< of an Outline: index into ArrangementInput::contours
    std::int32_t tag = 1;      ///< of the boundary part or point
    PieceRole role = PieceRole::Outline;
    /// The part of a curve that the piece stands for, if the caller numbers its curves; stretches of the piece come
    /// back with their part of the range.
    std::uint32_t curve = 0xffffffffU;
    double t0 = 0.0;
    double t1 = 1.0;
};

/// Which winding numbers are inside.
enum class FillRule : std::uint8_t { NonZero, EvenOdd };

/// Closed loops whose winding numbers are added: all subpaths of an SVG path, or one ring of a polygon.
struct ArrangementContour {
    std::uint32_t shape = 0;
    FillRule rule = FillRule::NonZero;
    bool hole = false; ///< what it encloses is taken out of its shape
};

/// What one path or polygon covers: everything inside at least one of its outer contours and inside none of its holes.
struct ArrangementShape {
    std::uint32_t feature = 0;
};

/// Shapes that belong together; a face belongs to one feature.
struct ArrangementFeature {
    std::int32_t regionTag = 1;
    std::string name; ///< for messages; may be empty
};

struct ArrangementInput {
    // Each returns the index of what it adds.
    std::uint32_t addFeature(std::int32_t regionTag, std::string name = {});
    std::uint32_t addShape(std::uint32_t feature);
    std::uint32_t addContour(std::uint32_t shape, FillRule rule = FillRule::NonZero, bool hole = false);
    /// A closed loop of a contour, its first node not repeated. Nodes equal to the one before are passed over.
    void addRing(std::uint32_t contour, std::span<const Vec2> nodes, std::int32_t tag);
    /// A line that the mesh must contain.
    void addChain(std::span<const Vec2> nodes, std::int32_t tag);
    void addPoint(Vec2 at, std::int32_t tag);

    std::vector<ArrangementPiece> pieces;
    std::vector<ArrangementContour> contours;
    std::vector<ArrangementShape> shapes;
    std::vector<ArrangementFeature> features;
    /// Nodes and segments closer than this are joined, in domain units. The resolution of doubles at these coordinates
    /// is the least that is used.
    double tolerance = 0.0;
    OverlapRule overlap = OverlapRule::Later;
    bool markRegions = false; ///< put a region marker into every face
    bool keepOutside = false; ///< keep lines and points that no shape covers
};

/// The part of a piece that a segment of the result follows.
struct PieceStretch {
    std::uint32_t piece = 0;
    double t0 = 0.0; ///< in the range of the piece's curve
    double t1 = 1.0;
};

struct Arrangement {
    /// Even-odd, without names. Nodes, segments and points come in the order of the pieces.
    Domain domain;
    std::vector<std::uint32_t> nodePiece;     ///< per node: the first piece that passes through it
    std::vector<PieceStretch> stretches;      ///< per segment: the first piece that runs along it
    std::vector<std::uint32_t> pointPiece;    ///< per constraint point
    std::vector<std::uint32_t> markerFeature; ///< per region marker: the feature that its face belongs to
    double radius = 0.0; ///< what was joined: the tolerance, or less where several things crowd within it
    std::vector<ArrangementChange> changes; ///< one entry per kind
};

/// The planar arrangement of labelled pieces as a domain: crossings, touchings and overlaps are found exactly and
/// become nodes; what is closer than the tolerance is joined (see snapLines); inside is what the shapes cover.
/// Outlines with the same feature on both sides disappear, except where two of its shapes only touch.
/// - Nothing moves by more than the tolerance. Nodes that nothing comes close to keep their coordinates bit for bit.
/// - A valid domain comes back with its nodes and segments in the order of the pieces.
/// - The result depends on the set of pieces, not on their order, which only numbers nodes and segments, chooses
///   between tags and decides between features.
/// Errors: non-finite, out-of-range, open-contour (a contour whose pieces do not form closed loops), cancelled.
Result<Arrangement> arrange(const ArrangementInput &input, std::stop_token stop = {});

} // namespace forefront
