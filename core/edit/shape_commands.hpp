#pragma once

#include "core/base/result.hpp"
#include "core/edit/references.hpp"

#include <set>
#include <span>

namespace forefront {

/// Commands on shapes: pure functions from a document to the next one. What cannot be done is refused with codes
/// bad-number (a coordinate is not finite), bad-tag (< 1), bad-shape (too few nodes, no radius), no-such-shape,
/// no-such-node, no-such-segment, not-possible.

/// Appends a shape; it gets the next id (`shape.id` is ignored).
Result<Document> addShape(const Document &document, Shape shape);
Result<Document> addShapes(const Document &document, std::vector<Shape> shapes);
Document removeShapes(const Document &document, const std::set<std::uint32_t> &ids);
/// Replaces a shape by an edited one of the same id.
Result<Document> replaceShape(const Document &document, Shape shape);
/// All that a selection holds is moved: shapes whole, handles alone, both ends of segments, sources and markers.
Result<Document> moveSelection(const Document &document, const Selection &selection, Vec2 by);
/// Deletes all that a selection holds; a node's neighbours are joined, a shape with too few nodes left goes.
Document deleteSelection(const Document &document, const Selection &selection);
/// Copies of the selected shapes and sources, moved by `by`; `copies`, if not null, becomes their selection.
Result<Document> duplicateSelection(const Document &document, const Selection &selection, Vec2 by, Selection *copies);

/// Puts a handle somewhere. The corner of a rectangle takes its neighbours along, the centre of a circle the circle.
Result<Document> setHandle(const Document &document, NodeRef node, Vec2 to);
Result<Document> setRadius(const Document &document, std::uint32_t circle, double radius);
/// Moves the second end of a segment so that it gets this length.
Result<Document> setSegmentLength(const Document &document, SegmentRef segment, double length);
/// A new node in a segment of a polygon or polyline (a rectangle becomes a polygon); both halves keep its tag.
Result<Document> insertNode(const Document &document, SegmentRef segment, Vec2 at);
/// Rectangle or circle as a polygon with the same outline.
Result<Document> convertToPolygon(const Document &document, std::uint32_t shape);
/// Opens a polygon at its first node, or closes a polyline of at least three nodes.
Result<Document> toggleClosed(const Document &document, std::uint32_t shape);

Result<Document> setShapeTag(const Document &document, const std::set<std::uint32_t> &ids, std::int32_t tag);
Result<Document> setSegmentTag(const Document &document, const std::set<SegmentRef> &segments, std::int32_t tag);
Result<Document> setShapeName(const Document &document, std::uint32_t id, std::string name);
Result<Document> setShapeUse(const Document &document, const std::set<std::uint32_t> &ids, ShapeUse use);

/// Puts a handle of a loose shape somewhere; the handle must exist.
void placeHandle(Shape &shape, std::uint32_t handle, Vec2 to);
/// What is wrong with a shape taken alone; empty if it can be in a document.
Diagnostics checkShape(const Shape &shape);

} // namespace forefront
