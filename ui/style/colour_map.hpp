#pragma once

#include "ui/style/colour.hpp"

namespace forefront {

/// Perceptually even colour maps for t in [0, 1]; interpolated between tabulated support colours of the published maps
/// (viridis: N. Smith and S. van der Walt; cividis: J. Nuñez, C. Anderton, R. Renslow).
Colour viridis(double t);
Colour cividis(double t);

} // namespace forefront
