#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/text_writer.hpp"

#include <string_view>

namespace forefront {

/// Reads SU2 (.su2), two-dimensional. Every fault carries its place in the source.
Result<Mesh> readSu2(const SourceText &source);
/// Returns true if the first bytes of a file show that it is of this format.
bool looksLikeSu2(std::string_view head);
/// Writes SU2 (.su2), two-dimensional.
void writeSu2(const MeshView &mesh, TextWriter &out);
/// Returns notes on the names and numbers of the mesh that the format changes.
Diagnostics noteSu2Changes(const MeshView &mesh);

} // namespace forefront
