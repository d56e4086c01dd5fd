#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/drawn_domain.hpp"
#include "core/drawing/domain/given_sizes.hpp"

namespace forefront {

/// Makes what two closed shapes of a document have drawn, each for itself, one line: see neighbourSides(). Lines with
/// other sizes, or whose layers, partner, crack or strip would be lost, stay two.
void joinNeighbours(const Document &document, DrawnDomain &drawn, const GivenSizes &given);

} // namespace forefront
