#pragma once

#include "core/drawing/arrangement/change.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/files/source/overlap_rule.hpp"

#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

// Turns the lines of a file into a domain that can be meshed.
//
// Why no library does this: we need labels on every piece of the boundary, results that depend on the geometry alone,
// vertices that stay where they are unless something is close, and a permissive licence.
// - GEOS 3.11 (LGPL): overlays two geometries at a time and rounds every vertex to a grid when given a precision; the
//   noder that keeps labels is internal C++ without a stable interface; no winding numbers.
// - CGAL 5.5: Snap_rounding_2 and Arrangement_2 do most of it, but are GPL, and snap rounding moves every vertex.
// - Boost.Polygon (Boost licence): integer coordinates of 32 bits, and the sets it returns carry no labels.
// - Clipper 6 (Boost licence): integer coordinates, closed paths without labels, no faces.
// The core already has the larger half of the work: exact predicates, plane sweep, faces.

namespace forefront {

/// The role of a piece of a drawing.
enum class PieceRole : std::uint8_t {
    Outline,    ///< part of a contour: counts for inside and outside
    Constraint, ///< a line that the mesh must contain
    Point       ///< a node that the mesh must contain; both ends are the same
};

/// Marks a shape or line that no clip limits.
inline constexpr std::uint32_t kNoClip = 0xffffffffU;

/// Marks a piece that represents only the shape of its contour.
inline constexpr std::uint32_t kNoShape = 0xffffffffU;

/// A straight piece of a drawing with its labels.
struct ArrangementPiece {
    Vec2 a;
    Vec2 b;
    std::uint32_t contour = 0; ///< of an Outline: index into ArrangementInput::contours
    std::int32_t tag = 1;      ///< of the boundary part or point
    PieceRole role = PieceRole::Outline;
    /// The part of a curve (an index into ArrangementInput::curves) of which the piece is a chord. The piece represents
    /// that part, and segments along the piece follow the corresponding parts of the curve. The ends of the piece must
    /// be on the curve within a few tolerances; otherwise only the chord counts.
    CurveStretch stretch = {};
    std::uint32_t limit = kNoClip; ///< of a Constraint: the clip outside of which it is dropped
    /// For a piece of a synthetic contour: a second shape, besides the contour's, that counts as present while this
    /// piece exists.
    std::uint32_t shows = kNoShape;
    /// The distance from outlines, in domain units, up to which parts of a Constraint that repeat them are dropped; 0:
    /// never. See findRepeatedOutlines().
    double reach = 0.0;
};

/// The rule that decides which winding numbers count as inside.
enum class FillRule : std::uint8_t { NonZero, EvenOdd };

/// Closed loops whose winding numbers are added: all subpaths of an SVG path, or one ring of a polygon.
struct ArrangementContour {
    std::uint32_t shape = 0;
    FillRule rule = FillRule::NonZero;
    bool hole = false;      ///< the area it encloses is removed from its shape
    bool synthetic = false; ///< not in the file itself; changes to its pieces are not reported
};

/// The area of one path or polygon: everything inside at least one of its outer contours and inside none of its holes,
/// as far as its clip shows it. Either a part of the domain or a part of a clip.
struct ArrangementShape {
    std::uint32_t feature = 0;      ///< unused if it is a part of a clip
    std::string name = {};          ///< for messages; may be empty
    std::uint32_t limit = kNoClip;  ///< the clip that limits it
    std::uint32_t partOf = kNoClip; ///< the clip that it is a part of
    bool removes = false;           ///< as a part of a clip: hides the area that it covers
};

/// An area that shapes are limited to. Its parts are painted in the order of their indices: a place belongs to the clip
/// if the last part that covers it does not remove it. A clip without parts is empty. No clip may depend on itself by
/// `within` or by the limits of its parts.
struct ArrangementClip {
    std::uint32_t within = kNoClip; ///< another clip that limits it, such as the clip of the enclosing group
};

/// Shapes that belong together; a face belongs to one feature.
struct ArrangementFeature {
    std::int32_t regionTag = 1;
    std::string name; ///< for messages; may be empty
};

struct ArrangementInput {
    // The next five return the index of the new entry.
    std::uint32_t addFeature(std::int32_t regionTag, std::string name = {});
    std::uint32_t addShape(std::uint32_t feature, std::string name = {}, std::uint32_t limit = kNoClip);
    std::uint32_t addClip(std::uint32_t within = kNoClip);
    /// Adds a shape to the parts of a clip and returns its index among the shapes.
    std::uint32_t addClipPart(std::uint32_t clip, std::uint32_t limit = kNoClip, bool removes = false);
    std::uint32_t addContour(std::uint32_t shape, FillRule rule = FillRule::NonZero, bool hole = false);
    /// Adds a closed loop to a contour; its first node is not repeated at the end. Nodes equal to the previous one are
    /// skipped. The stretches, if given, belong to the pieces that begin at the nodes; the last ones may be missing.
    void addRing(std::uint32_t contour, std::span<const Vec2> nodes, std::int32_t tag,
                 std::span<const CurveStretch> stretches = {});
    /// Adds a line that the mesh must contain, as far as a clip shows it and it does not repeat an outline within
    /// `reach`.
    void addChain(std::span<const Vec2> nodes, std::int32_t tag, std::span<const CurveStretch> stretches = {},
                  std::uint32_t limit = kNoClip, double reach = 0.0);
    void addPoint(Vec2 at, std::int32_t tag);
    /// Returns true for a piece of the outline of a clip.
    bool ofClip(const ArrangementPiece &piece) const {
        return piece.role == PieceRole::Outline && shapes[contours[piece.contour].shape].partOf != kNoClip;
    }

    /// Returns true for a piece of a synthetic contour.
    bool isSynthetic(const ArrangementPiece &piece) const {
        return piece.role == PieceRole::Outline && contours[piece.contour].synthetic;
    }

    std::vector<Curve> curves; ///< that pieces are chords of
    std::vector<ArrangementPiece> pieces;
    std::vector<ArrangementContour> contours;
    std::vector<ArrangementShape> shapes;
    std::vector<ArrangementFeature> features;
    std::vector<ArrangementClip> clips;
    /// Nodes, segments and curves closer than this are joined, in domain units. The minimum is the resolution of
    /// doubles at these coordinates, and a few times as much where pieces follow curves.
    double tolerance = 0.0;
    OverlapRule overlap = OverlapRule::Later;
    /// A later feature hides the parts of earlier ones that it covers, as in a painting: overlaps are not reported as
    /// conflicts, and a feature inside a later one disappears.
    bool layered = false;
    bool markRegions = false; ///< put a region marker into every face
    bool keepOutside = false; ///< keep lines and points that no shape covers
    /// Outlines that run along each other with the inside on both sides become a line; else both vanish.
    bool keepFolds = false;
};

/// The part of a piece that a segment of the result follows.
struct PieceStretch {
    std::uint32_t piece = 0;
    CurveStretch stretch; ///< the part of the piece's curve
};

struct Arrangement {
    /// The domain, with the even-odd rule, without names, and with the curves that segments follow. Nodes, segments and
    /// points come in the order of the pieces.
    Domain domain;
    std::vector<std::uint32_t> nodePiece;     ///< per node: the first piece through it
    std::vector<PieceStretch> stretches;      ///< per segment: the first piece that runs along it
    std::vector<std::uint8_t> isLine;         ///< per segment: 1 if it separates nothing and comes from a line
    std::vector<std::uint32_t> pointPiece;    ///< per constraint point
    std::vector<std::uint32_t> markerFeature; ///< per region marker: the feature that its face belongs to
    double radius = 0.0; ///< joining distance: the tolerance, or less if several things are crowded within it
    /// The total change by joining of the areas that contours run around, as a fraction of their sum.
    double areaChange = 0.0;
    std::vector<ArrangementChange> changes; ///< one entry per kind
};

/// Builds a domain from labelled pieces as their planar arrangement: crossings, contacts and overlaps are found
/// exactly and become nodes; things closer than the tolerance are joined (see snapLines); the inside is what the shapes
/// cover. Outlines with the same feature on both sides disappear, except where two of its shapes only touch.
/// - In a drawing with a single feature, shapes that another one hides are dropped first, see findHiddenShapes().
/// - Parts of lines that repeat an outline within their reach disappear, and the rest is then arranged again. Its ends
///   move to the outline, within that reach. Changes refer to the drawing as given.
/// - Outlines of clips appear only where they bound what a shape covers. Where they and synthetic contours cross or
///   touch other pieces, and where joining moves them, is not reported.
/// - Where pieces follow curves, the curves count, not their chords. Nodes at crossings lie on both curves to rounding.
///   Every crossing is found, unless the curves stay within the tolerance of each other beyond it. Curves that touch,
///   or come within the tolerance of each other, are joined where they are closest. Chords are divided as far as
///   needed.
/// - Nothing else moves by more than the tolerance. Nodes with nothing close to them keep their coordinates exactly.
/// - A valid domain is returned with its nodes and segments in the order of the pieces.
/// - The result depends on the set of pieces, not on their order, which only numbers nodes and segments, chooses
///   between tags and decides between features.
/// Errors: non-finite, out-of-range, open-contour (a contour whose pieces do not form closed loops, unless another
/// shape hides it), cancelled.
Result<Arrangement> arrange(const ArrangementInput &input, const std::stop_token &stop = {});

} // namespace forefront
