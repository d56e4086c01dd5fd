#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

// Commands that shorten and lengthen outlines up to where they meet others. Hidden shapes do not count. Errors:
// no-such-shape, no-such-node, not-possible.

/// Returns the positions where an outline meets others or itself, in ascending order: k + t for the parameter t of its
/// segment k. Takes long for outlines of many segments that meet many others.
Result<std::vector<double>> crossingsAlong(const Document &document, std::uint32_t shape);
/// Returns the part of an outline around a place that trimming removes: from the last crossing before it to the first
/// one after it, along segments and nodes. An open path is also bounded by its ends. `crossings`: those along the
/// outline. Error: not-possible if nothing crosses it, or a closed one is crossed at one place only.
Result<std::vector<Curve>> partToTrim(const Document &document, std::uint32_t shape, Vec2 at,
                                      std::span<const double> crossings);
/// Removes that part. A rectangle, circle or ellipse becomes a path, a closed path opens, and an open one may fall into
/// two, of which the second gets a new id. Where other shapes run along the part, which is one border to the eye, they
/// lose it too, unless they are locked.
Result<Document> trimAt(const Document &document, std::uint32_t shape, Vec2 at);

/// Returns the piece that extending an open path at one end adds: its last segment continued to the first crossing, an
/// arc along its ellipse, any other segment straight on. Error: not-possible if it meets nothing.
Result<Curve> extensionAt(const Document &document, NodeRef end);
/// Lengthens an open path by that.
Result<Document> extendEnd(const Document &document, NodeRef end);

} // namespace forefront
