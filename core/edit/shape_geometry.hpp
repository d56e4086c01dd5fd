#pragma once

#include "core/edit/document.hpp"

#include <optional>
#include <vector>

namespace forefront {

/// A shape as straight segments: segment k joins nodes k and k+1, the last one of a closed outline closes it.
struct Outline {
    std::vector<Vec2> nodes;
    bool closed = false;

    std::size_t segmentCount() const {
        return nodes.size() < 2 ? 0 : closed && nodes.size() > 2 ? nodes.size() : nodes.size() - 1;
    }
    Vec2 from(std::size_t segment) const { return nodes[segment]; }
    Vec2 to(std::size_t segment) const { return nodes[segment + 1 == nodes.size() ? 0 : segment + 1]; }
};

/// Corners of the polygon that stands for a circle: the least multiple of four, at least 8 and at most 4096, that keeps
/// the sagitta within `tolerance`·radius.
std::size_t circleCorners(double tolerance);

/// The nodes and segments that a shape brings into the domain. A rectangle runs from its first corner along x first; a
/// circle starts at its point, counter-clockwise.
Outline outlineOf(const Shape &shape, double circleTolerance);

/// Number of segments that can carry a tag of their own: as in the outline, but 1 for a circle (its whole line).
std::size_t taggedSegments(const Shape &shape);
/// Tag of a segment of the outline.
std::int32_t segmentTag(const Shape &shape, std::size_t segment);

/// Points a user can take hold of: the nodes; the four corners of a rectangle; centre and point of a circle.
std::vector<Vec2> handlesOf(const Shape &shape);
std::size_t handleCount(const Shape &shape);

bool isClosed(const Shape &shape);
double circleRadius(const Shape &shape);
Box2 boundsOf(const Shape &shape);
/// Bounds of all that is drawn; empty for an empty document.
Box2 boundsOf(const Document &document);
/// Even-odd; true also on the outline within rounding. Open shapes contain nothing.
bool contains(const Shape &shape, Vec2 p);
/// Absolute area enclosed; 0 for open shapes.
double areaOf(const Shape &shape);
/// Length of the outline; of a circle, its circumference.
double lengthOf(const Shape &shape);

/// "polygon", "polyline", ...
const char *kindName(ShapeKind kind);
/// The shape's own name, or one made of kind and id such as "polygon 3".
std::string displayName(const Shape &shape);

} // namespace forefront
