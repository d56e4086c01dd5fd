#pragma once

#include "core/engine/mesh/half_edges.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

namespace forefront {

/// Returns the element of a side 3·e + k of a mesh of triangles.
constexpr std::size_t elementOf(HalfEdge h) {
    return h / 3U;
}
/// Returns which side of its element a side of a mesh of triangles is.
constexpr unsigned sideOf(HalfEdge h) {
    return h % 3U;
}

} // namespace forefront
