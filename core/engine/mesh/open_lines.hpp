#pragma once

#include "core/engine/mesh/cracks.hpp"
#include "core/engine/mesh/edge_table.hpp"

#include <vector>

namespace forefront {

/// As openLines(mesh), with the table of the edges of the mesh.
std::vector<OpenLine> openLines(const MeshView &mesh, const EdgeTable &table);

} // namespace forefront
