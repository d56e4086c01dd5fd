#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/export_options.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/text_writer.hpp"

#include <string_view>

namespace forefront {

struct SolidMesh;

/// Reads Abaqus and CalculiX input (.inp). Every fault carries its place in the source.
Result<Mesh> readAbaqus(const SourceText &source);
/// Returns true if the first bytes of a file show that it is of this format.
bool looksLikeAbaqus(std::string_view head);
/// Writes Abaqus and CalculiX input (.inp).
void writeAbaqus(const MeshView &mesh, TextWriter &out);
/// Writes the same with ExportOptions::unit.
void writeAbaqusWith(const MeshView &mesh, const ExportOptions &options, TextWriter &out);
/// Returns notes on the names and numbers of the mesh that the format changes.
Diagnostics noteAbaqusChanges(const MeshView &mesh);

/// Writes prisms and hexahedra.
void writeAbaqusSolid(const SolidMesh &mesh, TextWriter &out);

} // namespace forefront
