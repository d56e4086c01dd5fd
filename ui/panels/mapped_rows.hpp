#pragma once

#include "core/drawing/document/document.hpp"

namespace forefront {

struct Shell;

/// Draws whether the faces of a region are filled by rows, and the corners of the face around its marker: the sharpest
/// ones, or three or four chosen nodes of its outline.
void mappedRows(Shell &context, const MarkedRegion &marker);

} // namespace forefront
