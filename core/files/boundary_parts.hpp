#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/import_options.hpp"

#include <cstdint>
#include <filesystem>
#include <map>

namespace FOREFRONT_API forefront {

/// Compares the boundary parts of a mesh with those named in its domain's file, without using the domain's reader: each
/// physical group of curves of an ASCII MSH file must be as long in the mesh as in the file unless it has curved lines
/// of 3 nodes, and the mesh must not call another part by its name. Files of other formats, and meshes without tags,
/// are not checked. Fault: wrong-part. `changes`: the change of the length of parts by a repair of the domain, by tag.
Diagnostics checkBoundaryParts(const MeshView &mesh, const std::filesystem::path &domainFile,
                               const ImportOptions &options = {}, const std::map<std::int32_t, double> &changes = {});

} // namespace forefront
