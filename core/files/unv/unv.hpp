#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/text_writer.hpp"

#include <string_view>

namespace forefront {

struct SolidMesh;

/// Reads a universal file of I-DEAS (.unv), ASCII: nodes (dataset 2411), elements (2412), groups (2467 and the earlier
/// 2435, 2452 and 2477 of the same layout). Every fault carries its place in the source.
Result<Mesh> readUnv(const SourceText &source);
/// Returns true if the first bytes of a file show that it is of this format.
bool looksLikeUnv(std::string_view head);
/// Writes a universal file.
void writeUnv(const MeshView &mesh, TextWriter &out);
/// Returns notes on the names of the mesh that the format changes.
Diagnostics noteUnvChanges(const MeshView &mesh);

/// Writes prisms and hexahedra.
void writeUnvSolid(const SolidMesh &mesh, TextWriter &out);

} // namespace forefront
