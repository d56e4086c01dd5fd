#pragma once

#include "core/drawing/constraints/document_sketch.hpp"
#include "core/drawing/document/document.hpp"

#include <cstddef>

namespace forefront {

/// Returns how many numbers of the shapes of a document are free that a sketch of it does not have: those of shapes
/// that neither constraints nor joints reach. Nodes of several shapes at the same place count once; numbers with
/// formulas and locked shapes do not count. Takes time in proportion to the drawing, without solving anything.
std::size_t freeNumbersBeside(const DocumentSketch &sketch, const Document &document);

} // namespace forefront
