#pragma once

#include "core/engine/mesh/tri_mesh.hpp"

namespace forefront {

/// Returns true if the mesh has elements and all of them are clockwise, by exact signs. Their nodes must exist.
bool isClockwise(const TriMesh &mesh);

/// Returns the mesh with every element turned the other way; its first node stays first.
TriMesh turned(TriMesh mesh);

} // namespace forefront
