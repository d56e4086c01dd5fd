#pragma once

#include "core/drawing/document/document.hpp"

namespace forefront {

/// Inserts nodes into segments where nodes of `shape` lie on them (see samePlaceDistance()), so that the
/// segments share these nodes: in other shapes, and in `shape` itself if it is a path. Rectangles, circles and ellipses
/// that get a node become paths. Returns the document unchanged if the shape does not exist, touches nothing, or is a
/// circle or an ellipse itself.
Document joinToSegments(const Document &document, std::uint32_t shape);

} // namespace forefront
