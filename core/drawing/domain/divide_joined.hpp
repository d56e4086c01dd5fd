#pragma once

#include "core/drawing/domain/drawn_domain.hpp"
#include "core/drawing/domain/given_sizes.hpp"

namespace forefront {

/// Divides what the nodes of other shapes lie on, unless a part would then be there twice: as where a line runs so
/// close to a side that it is on the side up to rounding, and yet is another.
void divideJoined(DrawnDomain &drawn, const GivenSizes &given);

} // namespace forefront
