#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// The elements with one region tag.
struct RegionExtent {
    std::int32_t tag = 1;
    std::string name; ///< empty if the mesh has none for the tag
    std::size_t elements = 0;
    double area = 0.0;
};

/// The tagged edges with one tag: a boundary part, an interface or a constraint.
struct BoundaryExtent {
    std::int32_t tag = 1;
    std::string name; ///< empty if the mesh has none for the tag
    std::size_t edges = 0;
    double length = 0.0;
};

/// The extent of a mesh: its parts, holes, regions and boundary.
struct MeshExtent {
    std::size_t parts = 0;                  ///< pieces that share no node with each other
    std::size_t holes = 0;                  ///< faces without elements that elements enclose
    std::vector<RegionExtent> regions;      ///< by ascending tag
    std::vector<BoundaryExtent> boundaries; ///< by ascending tag
};

/// Measures the extent of a valid mesh, with exact curved edges. `edges`: the number of different edges of its
/// elements, as in MeshQuality::segments. Holes are counted by Euler's formula.
MeshExtent extentOf(const MeshView &mesh, std::size_t edges);

} // namespace forefront
