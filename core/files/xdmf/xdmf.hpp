#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/common/mesh_field.hpp"
#include "core/files/source/export_options.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/file_set.hpp"

#include <array>
#include <filesystem>
#include <string_view>

namespace forefront {

/// Extensions of the files that writeXdmf writes side by side: the description, and its arrays in HDF5.
inline constexpr std::array<const char *, 2> kXdmfExtensions{".xdmf", ".h5"};

/// Returns true if the first bytes of a file show that it is XDMF.
bool looksLikeXdmf(std::string_view head);
/// Reads the mesh of an XDMF file, whose arrays lie in the file or in HDF5 files beside it. The elements are those of
/// the first grid with any; the tags of their regions its array of cells "region", or else its only array of whole
/// numbers. Grids of edges or points over the same nodes are boundary parts and points, with tags likewise. Faults
/// also: missing-component, where HDF5 is needed but absent.
Result<Mesh> readXdmf(const SourceText &source);
/// Reads the mesh and its scalar values of nodes and elements. Of several times, the first counts.
Result<MeshFields> readXdmfFields(const SourceText &source);

/// Adds PATH.xdmf and PATH.h5 to a set of files, as FEniCSx reads them: the grid "mesh" with the cells' array "region",
/// the grids "boundary" and "points" with arrays of the same names; <Information> holds the names of the tags. Fault:
/// missing-component, where HDF5 is absent.
Status writeXdmf(FileSet &files, const std::filesystem::path &path, const MeshView &mesh, const ExportOptions &options,
                 const Progress &progress);

} // namespace forefront
