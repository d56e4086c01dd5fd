#pragma once

#include "core/drawing/shapes/references.hpp"

#include <cstdint>
#include <set>

namespace forefront {

struct Shell;

/// Draws the size and growth of the boundary part with a tag; they apply wherever the tag is used.
void partSizeRow(Shell &context, std::int32_t tag);

/// Draws the size and growth of the region with a marker.
void regionSizeRow(Shell &context, std::uint32_t marker);

/// Draws the size and growth of those nodes that can have them. A field whose number differs between nodes is empty and
/// says so.
void nodeSizeRow(Shell &context, std::set<NodeRef> nodes);

} // namespace forefront
