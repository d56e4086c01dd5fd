#pragma once

#include "core/base/result.hpp"
#include "core/io/source/source.hpp"
#include "core/io/text/text_writer.hpp"
#include "core/mesh/mesh.hpp"

namespace forefront {

/// Reads Wavefront OBJ (.obj). Every fault carries its place in the source.
Result<Mesh> readObj(const SourceText &source);
/// Writes Wavefront OBJ (.obj).
void writeObj(const Mesh &mesh, TextWriter &out);
/// Returns notes on the names and numbers of the mesh that the format changes.
Diagnostics noteObjChanges(const Mesh &mesh);

} // namespace forefront
