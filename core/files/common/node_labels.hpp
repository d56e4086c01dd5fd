#pragma once

#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/source.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Returns one number per node for formats that label nodes: the tag of the point there, else the lowest tag of the
/// tagged edges that meet there, else 0.
std::vector<std::int32_t> nodeLabels(const MeshView &mesh);
/// Notes how many nodes of a mesh as read have a label other than 0 that no tagged edge or point there carries.
void noteUnusedLabels(const std::vector<std::int32_t> &labels, const Mesh &mesh, const char *code,
                      const SourceText &source);

} // namespace forefront
