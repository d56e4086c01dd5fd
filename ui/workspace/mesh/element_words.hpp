#pragma once

#include "core/engine/mesh/mesh_view.hpp"

#include <string>

namespace forefront {

/// Returns the number of elements of a mesh in words: "1,200 triangles", "90 elements (80 quadrilaterals, 10
/// triangles)".
std::string elementsInWords(const MeshView &mesh);

} // namespace forefront
