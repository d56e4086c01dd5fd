#pragma once

#include "ui/style/colour.hpp"

namespace forefront {

/// Returns the colour of the edges of a mesh over faces of another colour: lighter on dark faces, darker on light ones,
/// at a constant contrast of 3.3. The mesh is then equally visible, and equally quiet, wherever it lies.
Colour edgeOn(Colour face);

} // namespace forefront
