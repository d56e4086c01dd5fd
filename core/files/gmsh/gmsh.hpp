#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/files/common/mesh_field.hpp"
#include "core/files/source/export_options.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/text_writer.hpp"

#include <string_view>

namespace forefront {

struct SolidMesh;

/// Reads Gmsh MSH 2.2 (ASCII) and 4.1 (ASCII and binary). Every fault carries its place in the source.
Result<Mesh> readMsh(const SourceText &source);
/// Reads the first scalar $NodeData as the spacing on a background mesh. Faults: no-values, bad-values.
Result<SpacingSpec> readMshSpacing(const SourceText &source);
/// Reads the mesh and its scalar nodal values; of several time steps, the last.
Result<MeshFields> readMshFields(const SourceText &source);
/// Returns true if the first bytes of a file show that it is MSH.
bool looksLikeMsh(std::string_view head);

/// Writes MSH 2.2, ASCII.
void writeMsh2(const MeshView &mesh, TextWriter &out);
/// Writes MSH 4.1, ASCII.
void writeMsh4(const MeshView &mesh, TextWriter &out);
/// Writes MSH 4.1, binary.
void writeMsh4Binary(const MeshView &mesh, TextWriter &out);
/// Write the same with ExportOptions::keepTags and ExportOptions::unit.
void writeMsh2With(const MeshView &mesh, const ExportOptions &options, TextWriter &out);
void writeMsh4With(const MeshView &mesh, const ExportOptions &options, TextWriter &out);
void writeMsh4BinaryWith(const MeshView &mesh, const ExportOptions &options, TextWriter &out);
/// Returns notes on the names of the mesh that the format changes.
Diagnostics noteMshChanges(const MeshView &mesh, bool keepsTags);

/// Writes prisms and hexahedra as MSH 2.2, ASCII.
void writeMsh2Solid(const SolidMesh &mesh, TextWriter &out);

} // namespace forefront
