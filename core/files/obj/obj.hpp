#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/text_writer.hpp"

namespace forefront {

/// Reads Wavefront OBJ (.obj). Every fault carries its place in the source.
Result<Mesh> readObj(const SourceText &source);
/// Writes Wavefront OBJ (.obj).
void writeObj(const MeshView &mesh, TextWriter &out);
/// Returns notes on the names and numbers of the mesh that the format changes.
Diagnostics noteObjChanges(const MeshView &mesh);

} // namespace forefront
