#pragma once

#include "core/engine/mesh/mesh_view.hpp"

namespace forefront {

/// The exact signs of the triangles that each corner of an element makes with the two beside it; a triangle counts
/// three times.
struct CornerSigns {
    int positive = 0, negative = 0, zero = 0;

    /// Returns the exact sign of the area of the polygon of the corners. A quadrilateral that crosses itself, with two
    /// signs of each kind, has none: 0.
    int ofArea() const { return positive > negative ? 1 : positive < negative ? -1 : 0; }
};
CornerSigns cornerSigns(std::span<const Vec2> nodes, std::span<const NodeId> corners);

/// Returns true if the mesh has elements and the corners of all of them are clockwise, by exact signs. Their nodes must
/// exist.
bool isClockwise(const MeshView &mesh);
/// Returns the number of elements whose corners are clockwise, by exact signs, and the first of them.
struct ClockwiseElements {
    std::size_t count = 0, first = 0;
};
ClockwiseElements clockwiseElements(const MeshView &mesh);

/// Returns the mesh with every element turned the other way; its first corner stays first.
TriMesh turned(TriMesh mesh);
/// Returns the mesh with every element of any kind turned the other way; its first corner stays first.
Mesh turned(Mesh mesh);

} // namespace forefront
