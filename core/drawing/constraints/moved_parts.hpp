#pragma once

#include "core/drawing/document/document.hpp"

#include <vector>

namespace forefront {

/// Returns the nodes that a command has moved, and the arcs that it has bent, of shapes that have the same nodes
/// otherwise: in the order of the shapes.
std::vector<SketchPart> movedParts(const Document &before, const Document &next);

} // namespace forefront
