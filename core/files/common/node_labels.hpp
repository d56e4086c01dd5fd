#pragma once

#include "core/engine/mesh/mesh.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Returns one number per node for formats that label nodes: the tag of the point there, else the lowest tag of the
/// tagged edges that meet there, else 0.
std::vector<std::int32_t> nodeLabels(const Mesh &mesh);

} // namespace forefront
