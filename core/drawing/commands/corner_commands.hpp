#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

namespace forefront {

// Commands on the corners of paths and rectangles: the corners at selected nodes, or all corners of selected shapes.
// Errors: bad-number, no-such-node, not-possible (a smooth node, the end of an open path, or a corner that is too
// narrow for the number).

/// Rounds corners by arcs of circles that are tangent to both sides, which may be curves. The ends of an arc get the
/// element size of its corner. A rectangle all of whose corners are rounded stays a rectangle.
Result<Document> filletCorners(const Document &document, const Selection &selection, double radius);

/// Cuts corners by straight segments between the points at a distance from the node along both sides, which get the
/// element size of the corner.
Result<Document> chamferCorners(const Document &document, const Selection &selection, double distance);

/// Returns true if the selection holds a node or a shape with corners.
bool hasCorners(const Document &document, const Selection &selection);

} // namespace forefront
