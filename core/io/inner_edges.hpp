#pragma once

#include "core/mesh/mesh.hpp"

#include <cstdint>

namespace forefront {

/// Whether an exported mesh keeps its inner edges: tagged edges with triangles on both sides, such as constraints and
/// interfaces between regions. Some programs, deal.II among them, refuse boundary tags there.
enum class InnerEdges : std::uint8_t { Keep, Drop };

/// Returns a copy of the mesh without its inner edges. Names of tags no longer in use stay in the mesh.
Mesh withoutInnerEdges(const Mesh &mesh);

} // namespace forefront
