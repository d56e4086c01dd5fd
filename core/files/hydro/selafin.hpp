#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/export_options.hpp"
#include "core/files/text/file_set.hpp"

#include <array>
#include <filesystem>

namespace forefront {

/// Extensions of the files of a mesh of TELEMAC: the geometry, and the conditions on its boundary.
inline constexpr std::array<const char *, 2> kSelafinExtensions{".slf", ".cli"};

/// Adds the geometry (SELAFIN, single precision) and the boundary conditions (.cli) of a mesh of triangles for TELEMAC
/// to a set of files. The variable BOTTOM has the elevations. The origin moves by whole units if coordinates exceed
/// 1e5. Fault: not-manifold, with the place, if the boundary touches itself.
Status writeSelafin(FileSet &files, const std::filesystem::path &path, const MeshView &mesh,
                    const ExportOptions &options, const Progress &progress);

/// Returns notes on missing elevations and on an origin that moves.
Diagnostics noteSelafinChanges(const MeshView &mesh);

} // namespace forefront
