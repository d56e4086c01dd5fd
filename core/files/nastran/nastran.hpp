#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/text_writer.hpp"

#include <string_view>

namespace forefront {

struct SolidMesh;

/// Reads bulk data of Nastran (.bdf) in small, large and free fields: grid points in basic coordinates, plane elements,
/// rods and bars. Every fault carries its place in the source.
Result<Mesh> readNastran(const SourceText &source);
/// Returns true if the first bytes of a file show that it is of this format.
bool looksLikeNastran(std::string_view head);
/// Writes bulk data of Nastran.
void writeNastran(const MeshView &mesh, TextWriter &out);
/// Returns a note if coordinates are rounded.
Diagnostics noteNastranChanges(const MeshView &mesh);

/// Writes prisms and hexahedra.
void writeNastranSolid(const SolidMesh &mesh, TextWriter &out);

} // namespace forefront
