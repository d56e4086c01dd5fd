#pragma once

#include "core/engine/base/enum_words.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace forefront {

/// Treatment of inner edges in an exported mesh: tagged edges with elements on both sides, such as constraints and
/// interfaces between regions. Some programs, deal.II among them, refuse boundary tags there.
enum class InnerEdges : std::uint8_t { Keep, Drop };

template <>
struct EnumWords<InnerEdges> {
    static constexpr auto kLast = InnerEdges::Drop;
    static constexpr std::array<std::string_view, 2> kList = {"keep", "drop"};
};

/// Returns true if the mesh has inner edges.
bool hasInnerEdges(const MeshView &mesh);

/// Returns a copy of the mesh without its inner edges. Names of tags no longer in use stay in the mesh.
TriMesh withoutInnerEdges(const TriMesh &mesh);
Mesh withoutInnerEdges(const Mesh &mesh);

} // namespace forefront
