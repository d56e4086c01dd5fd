#pragma once

#include "core/drawing/shapes/references.hpp"

#include <set>

namespace forefront {

struct Shell;

/// Draws the number of elements along segments, a field for each of which the same number holds; draws nothing if they
/// cannot be counted.
void elementCountRow(Shell &context, const std::set<SegmentRef> &segments);

/// Draws the same row for shapes of one segment each: circles, ellipses, arcs and single lines.
void elementCountRow(Shell &context, const std::set<std::uint32_t> &shapes);

} // namespace forefront
