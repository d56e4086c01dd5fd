#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/common/mesh_field.hpp"
#include "core/files/source/export_options.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/text_writer.hpp"

namespace forefront {

/// Writes a grid of ADCIRC (fort.14): land is of type 20, islands of type 21.
void writeAdcirc(const MeshView &mesh, const ExportOptions &options, TextWriter &out);
/// Writes a grid of SCHISM (hgrid.gr3): land is of type 0, islands of type 1.
void writeSchism(const MeshView &mesh, const ExportOptions &options, TextWriter &out);
/// Reads a grid of ADCIRC or SCHISM. Its open boundaries are the parts open_1, open_2 and so on; land (types 0, 10 and
/// 20) and islands (1, 11 and 21) are one part each, other types such as barriers one for each type. Every fault
/// carries its place in the source.
Result<Mesh> readHydro(const SourceText &source);
/// Reads it with the elevations of its nodes, the depths with the other sign, as values "elevation", unless all are 0.
Result<MeshFields> readHydroFields(const SourceText &source);
/// Writes a mesh of MIKE 21 and MIKE 3 Flow Model FM (.mesh): nodes on land have the code 1, those on open parts 2 and
/// more in their order.
void writeMike(const MeshView &mesh, const ExportOptions &options, TextWriter &out);
/// Writes a mesh of ANUGA (.tsh).
void writeAnuga(const MeshView &mesh, TextWriter &out);
/// Returns notes on the names that are changed to identifiers, and that there are no elevations if the mesh has none.
Diagnostics noteAnugaChanges(const MeshView &mesh);
/// Returns a note that all depths are 0, if the mesh has no elevations.
Diagnostics noteDepths(const MeshView &mesh);

} // namespace forefront
