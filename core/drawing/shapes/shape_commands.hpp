#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

#include <set>
#include <span>
#include <string>
#include <vector>

namespace forefront {

// Commands on shapes: pure functions from a document to the next one. Errors: bad-number (a coordinate is not finite),
// bad-tag (< 1), bad-shape (too few nodes, no radius), bad-curve, no-such-shape, no-such-node, no-such-segment,
// not-possible.

/// Appends a shape with the next id; `shape.id` is ignored.
Result<Document> addShape(const Document &document, Shape shape);
Result<Document> addShapes(const Document &document, std::vector<Shape> shapes);
Document removeShapes(const Document &document, const std::set<std::uint32_t> &ids);
/// Replaces a shape by an edited one with the same id.
Result<Document> replaceShape(const Document &document, Shape shape);
/// Replaces shapes by edited ones with the same ids, in one pass over the document. Where the list of nodes has
/// changed, replaceShape() moves the sizes of nodes that were not edited to the same places; replaceShapes() does not.
Result<Document> replaceShapes(const Document &document, std::vector<Shape> shapes);
/// Moves everything selected: whole shapes, single handles, both ends of segments, sources and markers.
Result<Document> moveSelection(const Document &document, const Selection &selection, Vec2 by);
/// Deletes everything selected. Neighbours of a deleted node are joined; shapes with too few nodes left are deleted.
Document deleteSelection(const Document &document, const Selection &selection);
/// Copies the selected shapes, sources and markers and moves the copies by `by`; `copies`, if not null, becomes their
/// selection.
Result<Document> duplicateSelection(const Document &document, const Selection &selection, Vec2 by, Selection *copies);

/// Moves a handle to a place. A corner of a rectangle takes the two adjacent corners with it, and the centre of a
/// circle the whole circle. The side of a slot changes its width.
Result<Document> setHandle(const Document &document, NodeRef node, Vec2 to);
Result<Document> setRadius(const Document &document, std::uint32_t circle, double radius);
/// Moves the second end of a segment so that it gets this length.
Result<Document> setSegmentLength(const Document &document, SegmentRef segment, double length);
/// Gives a segment of a path that is an arc of a circle another radius; its ends stay.
Result<Document> setArcRadius(const Document &document, SegmentRef segment, double radius);
/// Inserts a node into a segment of a path (a rectangle or slot becomes one); both parts keep tag and curve.
Result<Document> insertNode(const Document &document, SegmentRef segment, Vec2 at);
/// Converts a rectangle, circle, ellipse or slot to a closed path with the same outline: see becomePath().
Result<Document> convertToPath(const Document &document, std::uint32_t shape);
/// The same for several shapes; paths and points are unchanged. Error: not-possible if there are no others.
Result<Document> convertToPaths(const Document &document, const std::set<std::uint32_t> &shapes);
/// Opens a polygon at its first node, or closes a polyline of at least three nodes.
Result<Document> toggleClosed(const Document &document, std::uint32_t shape);

Result<Document> setShapeTag(const Document &document, const std::set<std::uint32_t> &ids, std::int32_t tag);
Result<Document> setSegmentTag(const Document &document, const std::set<SegmentRef> &segments, std::int32_t tag);
Result<Document> setShapeName(const Document &document, std::uint32_t id, std::string name);
/// Hides shapes, or shows them again.
Result<Document> setHidden(const Document &document, const std::set<std::uint32_t> &ids, bool hidden);
/// Locks shapes, or unlocks them.
Result<Document> setLocked(const Document &document, const std::set<std::uint32_t> &ids, bool locked);
Result<Document> setShapeUse(const Document &document, const std::set<std::uint32_t> &ids, ShapeUse use);

/// Moves a handle of a shape outside a document; the handle must exist.
void placeHandle(Shape &shape, std::uint32_t handle, Vec2 to);
/// Returns the faults of a single shape; empty if it can be part of a document.
Diagnostics checkShape(const Shape &shape);

} // namespace forefront
