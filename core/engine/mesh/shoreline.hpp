#pragma once

#include "core/engine/mesh/mesh_view.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A stretch of the boundary of a mesh of water.
struct ShoreStretch {
    enum class Kind : std::uint8_t { Open, Land, Island };
    Kind kind = Kind::Land;
    /// In order with the water on the left: counter-clockwise around the mesh, clockwise around islands. Stretches that
    /// follow each other share a node; a stretch all around the mesh has its first node again at the end, an island has
    /// not.
    std::vector<NodeId> nodes;
};

/// Divides the boundary of a mesh, the sides of elements without a neighbour, into open stretches, one for each part
/// and place, in the order of `openTags`, then land, then islands: whole loops inside another without an open side.
/// Sides that are not tagged are land.
std::vector<ShoreStretch> shoreline(const MeshView &mesh, std::span<const std::int32_t> openTags);

} // namespace forefront
