#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/text_writer.hpp"

#include <string_view>

namespace forefront {

struct SolidMesh;

/// Reads MEDIT (.mesh), ASCII. Every fault carries its place in the source.
Result<Mesh> readMedit(const SourceText &source);
/// Returns true if the first bytes of a file show that it is of this format.
bool looksLikeMedit(std::string_view head);
/// Writes MEDIT (.mesh), ASCII.
void writeMedit(const MeshView &mesh, TextWriter &out);

/// Writes prisms and hexahedra.
void writeMeditSolid(const SolidMesh &mesh, TextWriter &out);

} // namespace forefront
