#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/drawn_domain.hpp"

namespace forefront {

/// Divides what the nodes of other shapes lie on, unless a part would then be there twice: as where a line runs so
/// close to a side that it is on the side up to rounding, and yet is another.
/// Adds notes on what was joined and what was not to DrawnDomain::findings.
void divideJoined(const Document &document, DrawnDomain &drawn);

} // namespace forefront
