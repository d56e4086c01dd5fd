#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/drawn_domain.hpp"

namespace forefront {

/// Makes what two closed shapes of a document have drawn, each for itself, one line: see neighbourSides(). What one of
/// them has along it holds for both, see chooseSide(); a conflict is added to DrawnDomain::findings, and they stay two.
void joinNeighbours(const Document &document, DrawnDomain &drawn);

} // namespace forefront
