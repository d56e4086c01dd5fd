#pragma once

#include "core/engine/mesh/mesh.hpp"

namespace forefront {

/// Returns true if the mesh has elements and all of them are clockwise, by exact signs. Their nodes must exist.
bool isClockwise(const Mesh &mesh);

/// Returns the mesh with every element turned the other way; its first node stays first.
Mesh turned(Mesh mesh);

} // namespace forefront
