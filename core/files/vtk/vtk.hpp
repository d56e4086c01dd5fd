#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/common/mesh_field.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/text_writer.hpp"

#include <string_view>

namespace forefront {

struct SolidMesh;

/// Reads a VTK XML unstructured grid (.vtu). Every fault carries its place in the source.
Result<Mesh> readVtu(const SourceText &source);
/// Reads the mesh and its scalar point and cell data.
Result<MeshFields> readVtuFields(const SourceText &source);
/// Returns true if the first bytes of a file show that it is VTU.
bool looksLikeVtu(std::string_view head);
/// Writes a VTK XML unstructured grid (.vtu).
void writeVtu(const MeshView &mesh, TextWriter &out);

/// Reads a VTK legacy file (.vtk), ASCII. Every fault carries its place in the source.
Result<Mesh> readVtk(const SourceText &source);
/// Reads the mesh and its scalar point and cell data.
Result<MeshFields> readVtkFields(const SourceText &source);
/// Returns true if the first bytes of a file show that it is VTK legacy.
bool looksLikeVtk(std::string_view head);
/// Writes a VTK legacy file, ASCII.
void writeVtk(const MeshView &mesh, TextWriter &out);

/// Writes prisms and hexahedra as VTU.
void writeVtuSolid(const SolidMesh &mesh, TextWriter &out);

} // namespace forefront
