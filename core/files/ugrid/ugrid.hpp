#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/export_options.hpp"
#include "core/files/text/text_writer.hpp"

namespace forefront {

/// Writes a mesh by the conventions UGRID 1.0 in a netCDF file of the classic format, as Delft3D FM and QGIS read it:
/// nodes with their elevations, all edges, faces of three or four nodes; the regions of faces and the boundary parts of
/// edges as flags, whose meanings are their names made identifiers (0: none).
void writeUgrid(const MeshView &mesh, const ExportOptions &options, TextWriter &out);

/// Returns notes on changed names, and that all elevations are 0 if the mesh has none.
Diagnostics noteUgridChanges(const MeshView &mesh);

} // namespace forefront
