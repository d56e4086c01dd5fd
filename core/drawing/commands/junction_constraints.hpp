#pragma once

#include "core/drawing/document/document.hpp"

namespace forefront {

/// Makes junctions that a command has made smooth, as by a fillet, tangent by constraints where a segment or node
/// beside them is constrained. `after` is the settled document. Junctions that its constraints already keep smooth get
/// none. No shape moves.
Document constrainJunctions(const Document &before, const Document &after);

} // namespace forefront
