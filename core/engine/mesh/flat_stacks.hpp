#pragma once

#include "core/engine/mesh/measures.hpp"

#include <vector>

namespace forefront {

/// Returns for each element whether it belongs to a boundary layer, by the shapes alone, since files of meshes do not
/// say which elements layers made: whether it lies in a stack of flat elements on the boundary. A stack starts at an
/// edge of the boundary and continues over the edge that faces it, as long as the elements, or the pairs of triangles
/// that halve a quadrilateral, are lower than 0.7 times their width, where layers end of themselves. Flat
/// quadrilaterals beside a stack belong to it, too, such as those of a fan.
std::vector<bool> elementsOfFlatStacks(const MeshView &mesh, const MeshEdges &edges);

} // namespace forefront
