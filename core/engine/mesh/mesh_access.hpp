#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace FOREFRONT_API forefront {

/// Returns the coordinates of the nodes as one array: x and y of each in turn. Valid as long as the mesh is unchanged.
std::span<const double> coordinates(const MeshView &mesh);
/// Returns the nodes of the triangles as one array: three indices of each in turn, counter-clockwise. Valid as long as
/// the mesh is unchanged. Those of other kinds of elements are in CellBlock::connectivity().
std::span<const std::uint32_t> connectivity(const TriMesh &mesh);

/// Returns the tagged edges that carry a tag, as ascending indices into Mesh::edges.
std::vector<std::uint32_t> edgesWithTag(const MeshView &mesh, std::int32_t tag);

/// The elements on either side of a tagged edge, as seen from its node a towards its node b, and their regions. Outside
/// the mesh, the element is kNoElement and the region 0.
struct EdgeSides {
    ElementId left = kNoElement, right = kNoElement;
    std::int32_t leftRegion = 0, rightRegion = 0;

    /// Returns true for an interface between two regions.
    bool isInterface() const { return leftRegion != 0 && rightRegion != 0 && leftRegion != rightRegion; }
    friend bool operator==(const EdgeSides &, const EdgeSides &) = default;
};

/// Returns the sides of each tagged edge, in the order of Mesh::edges. On the boundary of a mesh that this library
/// made, the mesh is on the left. The indices of the mesh must be valid, see verify(). An edge that is not in the mesh
/// has no sides.
std::vector<EdgeSides> edgeSides(const MeshView &mesh);

} // namespace forefront
