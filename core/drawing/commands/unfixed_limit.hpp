#pragma once

#include "core/engine/mesh/limits.hpp"

#include <string>

namespace forefront {

/// Returns why no setting brings a mesh nearer to a limit for which fixOf() has no command, and what helps instead:
/// "the outline forces this: change it there, or the limit". `layered`: the mesh has boundary layers.
std::string whyNoFix(MeshLimit limit, bool layered);

} // namespace forefront
