#pragma once

#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/mesh/quality.hpp"

#include <array>
#include <cstddef>
#include <string>

namespace forefront {

/// Returns the number of elements of a mesh in words: "1,200 triangles", "90 elements (80 quadrilaterals, 10
/// triangles)".
std::string elementsInWords(const MeshView &mesh);
/// Returns it for numbers of elements by CellKind, as in MeshQuality.
std::string elementsInWords(const std::array<std::size_t, wordsOf<CellKind>().size()> &counts);

/// Returns the number of elements for narrow places: "1,200 △" if all are triangles, of any order, else "90 elements".
std::string elementsInShort(const MeshQuality &quality);

} // namespace forefront
