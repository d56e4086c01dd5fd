#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/drawn_domain.hpp"
#include "core/drawing/domain/given_sizes.hpp"

namespace forefront {

/// Adds the shapes of a document to an empty domain, each for itself: nodes at the same place become one, see
/// JoinedPlaces, and curves become chords. Construction geometry is left out.
void drawShapes(const Document &document, DrawnDomain &drawn, const GivenSizes &given);

} // namespace forefront
