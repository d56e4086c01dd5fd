#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/mesh/mesh.hpp"
#include "core/engine/mesh/tri_mesh.hpp"
#include "core/files/source/source.hpp"

#include <string_view>

namespace forefront {

/// Reads a plane mesh of Netgen (.vol), ASCII. Elements of the surface give the triangles and their regions, edge
/// segments the boundary parts. Every fault carries its place in the source.
Result<Mesh> readNetgen(const SourceText &source);
/// Returns true if the first bytes of a file show that it is of this format.
bool looksLikeNetgen(std::string_view head);

} // namespace forefront
