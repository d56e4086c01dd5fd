#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"

namespace forefront {

// Commands that make a part of a mesh a constraint of the drawing, so that every later mesh has it too. Errors:
// bad-number, bad-tag, not-possible (the place lies on a circle, or the drawing already has a node there).

/// Pins a node: adds a constraint point with this tag, or a node to the segment that the place lies on (within 1e-6 of
/// the drawing's size).
Result<Document> pinNode(const Document &document, Vec2 at, std::int32_t tag);

/// Keeps an edge: adds a constraint segment with this tag. Where its ends lie on segments, these get a node.
Result<Document> keepEdge(const Document &document, Vec2 a, Vec2 b, std::int32_t tag);

} // namespace forefront
