#pragma once

#include "core/engine/mesh/measures.hpp"

#include <vector>

namespace forefront {

/// Returns for each edge of a mesh the number of edges on the shortest path through it that joins two facing walls; NaN
/// where the ends of that path do not face each other. Walls are the boundary, the interfaces of regions and tagged
/// edges such as constraints. The minimum is the number of elements across the narrowest gap or layer. Two nodes face
/// each other if they lie on different loops of walls, or if the distance along their loop is more than four times the
/// straight distance, so that corners of more than about 30 degrees are no gaps. O(n log n).
std::vector<double> elementsAcross(const MeshView &mesh, const MeshEdges &edges);

} // namespace forefront
