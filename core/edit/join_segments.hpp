#pragma once

#include "core/edit/document.hpp"

namespace forefront {

/// Inserts nodes into segments of other shapes where nodes of `shape` lie on them (within 1e-9 of the drawing's size),
/// so that the shapes share these nodes. Rectangles that get a node become paths; circles and ellipses are left alone.
/// Returns the document unchanged if the shape does not exist or touches nothing.
Document joinToSegments(const Document &document, std::uint32_t shape);

} // namespace forefront
