#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/files/source/source.hpp"
#include "core/files/text/text_writer.hpp"

#include <string_view>

namespace forefront {

/// Reads a mesh of MFEM (mesh v1.0 and v1.2) with straight edges, or with nodes of second order. Every fault carries
/// its place in the source.
Result<Mesh> readMfem(const SourceText &source);
/// Returns true if the first bytes of a file show that it is of this format.
bool looksLikeMfem(std::string_view head);
/// Writes a mesh of MFEM (mesh v1.0); one of second order with all elements as such.
void writeMfem(const MeshView &mesh, TextWriter &out);

} // namespace forefront
