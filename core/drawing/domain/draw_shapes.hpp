#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/drawn_domain.hpp"
#include "core/drawing/domain/given_sizes.hpp"

namespace forefront {

/// Adds the shapes of a document to an empty domain, each for itself: nodes at the same place become one, curves become
/// chords. Notes in `given` what is given for their segments. Construction geometry is left out.
void drawShapes(const Document &document, DrawnDomain &drawn, GivenSizes &given);

} // namespace forefront
