#pragma once

#include "core/drawing/document/document.hpp"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace forefront {

/// The nodes and segments of a shape: segment k joins nodes k and k+1; in a closed outline the last one closes it.
struct Outline {
    std::vector<Vec2> nodes;
    bool closed = false;
    /// Per segment, its curve. A curve of kind Line marks a straight segment; its ends are ignored. Empty: all
    /// segments are straight.
    std::vector<Curve> curves;
    /// Per segment, the index of the tagged part (see taggedSegments()) that it belongs to. Empty: each segment is a
    /// part.
    std::vector<std::uint32_t> parts;

    std::size_t segmentCount() const {
        const bool loop = closed && (nodes.size() > 2 || !curves.empty());
        return loop ? nodes.size() : nodes.empty() ? 0 : nodes.size() - 1;
    }
    Vec2 from(std::size_t segment) const { return nodes[segment]; }
    Vec2 to(std::size_t segment) const { return nodes[segment + 1 == nodes.size() ? 0 : segment + 1]; }
    bool isCurved(std::size_t segment) const {
        return segment < curves.size() && curves[segment].kind() != CurveKind::Line;
    }
    /// Returns the curve of a segment; a line from node to node if it is straight.
    Curve curve(std::size_t segment) const {
        return isCurved(segment) ? curves[segment] : Curve::line(from(segment), to(segment));
    }
    std::uint32_t part(std::size_t segment) const {
        return segment < parts.size() ? parts[segment] : static_cast<std::uint32_t>(segment);
    }
};

/// Returns the nodes and segments of a shape. A rectangle starts at its first corner along x; one with rounded corners
/// has up to eight segments. A circle is one segment that starts at its point, counter-clockwise; so is an ellipse. A
/// slot is a side and an end in turn, counter-clockwise, from the right of its first centre.
Outline outlineOf(const Shape &shape);

/// An outline as straight segments: chord k joins nodes k and k+1; in a closed outline the last one closes it.
struct Chords {
    std::vector<Vec2> nodes;
    bool closed = false;
    std::vector<std::uint32_t> segments; ///< per chord: its segment of the outline
    std::vector<CurveStretch> stretches; ///< per chord: the part of the curve of that segment; none if it is straight

    std::size_t size() const { return segments.size(); }
    Vec2 from(std::size_t chord) const { return nodes[chord]; }
    Vec2 to(std::size_t chord) const { return nodes[chord + 1 == nodes.size() ? 0 : chord + 1]; }
};

/// Returns the chords that represent a shape in a domain; `outline` is the outline of the shape, and the curves of the
/// stretches are its segments. See Document::circleTolerance.
Chords chordsOf(const Shape &shape, const Outline &outline, double circleTolerance);

/// Returns the number of corners of the polygon for a circle: the smallest multiple of four in [8, 4096] that keeps the
/// sagitta within `tolerance`·radius.
std::size_t circleCorners(double tolerance);

/// Returns the number of parts that can have their own tag: 4 for a rectangle (its sides), 8 if its corners are rounded
/// (the sides, then the arc after each), 4 for a slot, 1 for a circle or an ellipse, else the number of segments of the
/// outline.
std::size_t taggedSegments(const Shape &shape);
/// Returns the tag of a part; see taggedSegments(). If only the sides of a rounded rectangle have tags, as in drawings
/// of older versions, an arc has the tag of the side before it.
std::int32_t segmentTag(const Shape &shape, std::size_t part);
/// Returns the tags of all parts.
std::vector<std::int32_t> segmentTagsOf(const Shape &shape);
/// Returns true for an arc at a corner of a rectangle.
bool isRoundedCorner(const Shape &shape, std::size_t part);
/// Returns the handles that move with a part: its ends, the corner of an arc, or all of a shape without ends.
std::set<std::uint32_t> handlesOfPart(const Shape &shape, std::uint32_t part);

/// Returns the points that can be dragged: the nodes, the four corners of a rectangle; centre and point of a circle,
/// centre and the ends of both semi-axes of an ellipse; both centres of a slot and the middle of its left side.
std::vector<Vec2> handlesOf(const Shape &shape);
std::size_t handleCount(const Shape &shape);
/// Returns true for a handle that is a centre of a circle, an ellipse or a slot.
bool isCentre(const Shape &shape, std::uint32_t handle);

/// Returns true for polygons and polylines, whose nodes and segments can be edited one by one.
bool isPath(const Shape &shape);
/// Returns true for circles and ellipses, whose outline is one curve.
bool isRound(const Shape &shape);
bool isClosed(const Shape &shape);
double circleRadius(const Shape &shape);
Box2 boundsOf(const Shape &shape);
/// Returns the largest radius that the corners of a rectangle can have: half of its shorter side.
double largestRounding(const Shape &rectangle);
/// Returns the box of the whole drawing; empty for an empty document.
Box2 boundsOf(const Document &document);
/// Returns true if p is inside by the even-odd rule, or on the outline up to rounding. Curves of paths count as their
/// chords. Open shapes contain nothing.
bool contains(const Shape &shape, Vec2 p);
/// Returns the enclosed area (>= 0); 0 for open shapes.
double areaOf(const Shape &shape);
/// Returns the length of the outline.
double lengthOf(const Shape &shape);

/// Moves all nodes and curves of a shape.
void moveShape(Shape &shape, Vec2 by);
/// Scales a shape about the origin; `factor` must not be 0.
void scaleShape(Shape &shape, double factor);
/// Turns a rectangle, circle, ellipse or slot into a closed path with the same outline; leaves other shapes unchanged.
/// A circle and an ellipse get four nodes.
void becomePath(Shape &shape);
/// Moves nodes of a path to new places, one for each node; curves move with their ends.
void moveNodes(Shape &shape, std::vector<Vec2> places);

/// Returns the word for the form of a shape: the name of its kind, or "slot" for a path of that form.
std::string kindName(const Shape &shape);
/// Returns the name of a shape, or one made of its kind and id such as "polygon 3".
std::string displayName(const Shape &shape);

} // namespace forefront
