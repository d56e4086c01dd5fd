#pragma once

#include "core/edit/document.hpp"

#include <optional>
#include <vector>

namespace forefront {

/// A shape as straight segments: segment k joins nodes k and k+1; in a closed outline the last one closes it.
struct Outline {
    std::vector<Vec2> nodes;
    bool closed = false;

    std::size_t segmentCount() const {
        return nodes.size() < 2 ? 0 : closed && nodes.size() > 2 ? nodes.size() : nodes.size() - 1;
    }
    Vec2 from(std::size_t segment) const { return nodes[segment]; }
    Vec2 to(std::size_t segment) const { return nodes[segment + 1 == nodes.size() ? 0 : segment + 1]; }
};

/// Returns the number of corners of the polygon for a circle: the smallest multiple of four in [8, 4096] that keeps the
/// sagitta within `tolerance`·radius.
std::size_t circleCorners(double tolerance);

/// Returns the nodes and segments of a shape in the domain. A rectangle starts at its first corner along x, a circle at
/// its point, counter-clockwise.
Outline outlineOf(const Shape &shape, double circleTolerance);

/// Returns the number of segments that can have their own tag: those of the outline, but 1 for a circle.
std::size_t taggedSegments(const Shape &shape);
/// Returns the tag of a segment of the outline.
std::int32_t segmentTag(const Shape &shape, std::size_t segment);

/// Returns the points that can be dragged: the nodes, the four corners of a rectangle, centre and point of a circle.
std::vector<Vec2> handlesOf(const Shape &shape);
std::size_t handleCount(const Shape &shape);

bool isClosed(const Shape &shape);
double circleRadius(const Shape &shape);
Box2 boundsOf(const Shape &shape);
/// Returns the box of the whole drawing; empty for an empty document.
Box2 boundsOf(const Document &document);
/// Returns true if p is inside by the even-odd rule, or on the outline up to rounding. Open shapes contain nothing.
bool contains(const Shape &shape, Vec2 p);
/// Returns the enclosed area (>= 0); 0 for open shapes.
double areaOf(const Shape &shape);
/// Returns the length of the outline; for a circle, its circumference.
double lengthOf(const Shape &shape);

/// Returns the name of a shape, or one made of its kind and id such as "polygon 3".
std::string displayName(const Shape &shape);

} // namespace forefront
