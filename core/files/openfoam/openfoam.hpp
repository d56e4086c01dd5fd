#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/export_options.hpp"
#include "core/files/text/file_set.hpp"

#include <array>
#include <filesystem>

namespace forefront {

/// The files of a case of OpenFOAM with a mesh. case.foam is empty: ParaView opens the case by it.
inline constexpr std::array<const char *, 8> kFoamFiles{"constant/polyMesh/points",    "constant/polyMesh/faces",
                                                        "constant/polyMesh/owner",     "constant/polyMesh/neighbour",
                                                        "constant/polyMesh/boundary",  "constant/polyMesh/cellZones",
                                                        "constant/polyMesh/faceZones", "case.foam"};

/// Adds the mesh of a case of OpenFOAM (polyMesh, ASCII) to a set of files, in a folder that is made if it does not
/// exist: cells of ExportOptions::extrusion, or one layer of usualExtrusion(); boundary parts as patches of type patch,
/// sides without a tag as defaultFaces, regions as cell zones, tagged edges inside as face zones. Front and back are
/// one patch frontAndBack of type empty if there is one layer, else the patches back and front. Names are identifiers.
///
/// Faults: cannot-write, if the folder cannot be made or holds files of another mesh that OpenFOAM would read, too;
/// not-manifold, if more than two elements share an edge.
Status writeOpenFoam(FileSet &files, const std::filesystem::path &folder, const MeshView &mesh,
                     const ExportOptions &options, const Progress &progress);

/// Returns a note on the names that are changed to identifiers.
Diagnostics noteOpenFoamChanges(const MeshView &mesh);

} // namespace forefront
