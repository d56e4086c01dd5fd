#pragma once

#include "core/drawing/shapes/references.hpp"

#include <cstdint>
#include <set>

namespace forefront {

struct Shell;

/// Draws the size and growth of segments; they change no tag. A field whose number differs between segments is empty
/// and says so.
void segmentSizeRow(Shell &context, const std::set<SegmentRef> &segments);

/// Draws the size and growth of the boundary part with a tag; they apply wherever the tag is used. Draws nothing for a
/// part that has neither a name nor a size.
void partSizeRow(Shell &context, std::int32_t tag);

/// Returns all segments of shapes.
std::set<SegmentRef> segmentsOf(const Document &document, const std::set<std::uint32_t> &shapes);

/// Draws the size and growth of the region with a marker.
void regionSizeRow(Shell &context, std::uint32_t marker);

/// Draws the size and growth of those nodes that can have them. A field whose number differs between nodes is empty and
/// says so.
void nodeSizeRow(Shell &context, std::set<NodeRef> nodes);

} // namespace forefront
