#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/export_options.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// Returns the parts of the boundary of a mesh, which can be open: the names of its tagged edges with an element on one
/// side alone, by tag.
std::map<std::int32_t, std::string> boundaryPartsOf(const MeshView &mesh);

/// Returns those of the tags that are parts of the boundary of a mesh, in order.
std::vector<std::int32_t> openPartsIn(const MeshView &mesh, std::span<const std::int32_t> tags);

/// Returns the note "no-open-boundary" if a file that writeMesh writes tells open boundaries from land and has none.
/// `advice`: how to open a part, such as "--open NAME opens a part".
Diagnostics noteAllLand(const std::filesystem::path &path, std::string_view formatId, const ExportOptions &options,
                        const std::string &advice);

} // namespace forefront
