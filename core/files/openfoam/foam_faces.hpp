#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/export_options.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace forefront {

/// A face of a polyhedral mesh; its normal points from its owner to its neighbour, or out of the mesh.
struct FoamFace {
    std::array<std::uint32_t, 4> corners = {};
    std::uint8_t count = 4; ///< of its corners: 3 or 4
    std::uint32_t owner = 0;
    std::uint32_t neighbour = 0; ///< above the owner; only of inner faces

    std::span<const std::uint32_t> nodes() const { return std::span(corners).first(count); }
};

/// Faces inside that belong to a tagged edge.
struct FoamZone {
    std::vector<std::size_t> faces; ///< ascending
    std::vector<bool> flipped;      ///< whether the normal of the face points to the left of its edge
};

/// The faces of an extruded mesh: inner ones first, in the order of their owners, then neighbours (the upper triangle
/// of a matrix, row by row), as OpenFOAM's solvers expect them; then those of each part of the boundary.
struct FoamFaces {
    std::vector<FoamFace> faces;
    std::size_t inner = 0;                               ///< number of inner faces
    std::map<std::int32_t, std::vector<FoamFace>> parts; ///< boundary faces over tagged edges
    std::vector<FoamFace> untagged, back, front;         ///< other boundary faces
    std::map<std::int32_t, FoamZone> zones;              ///< of tagged edges inside
};

/// Returns the faces of a mesh extruded in layers, with nodes and cells numbered as in SolidMesh. `faces` holds the
/// inner ones alone. Fault: not-manifold, with the place, if more than two elements share an edge.
Result<FoamFaces> foamFaces(const MeshView &mesh, std::uint32_t layers);

} // namespace forefront
