#pragma once

#include "core/engine/mesh/mesh_view.hpp"

namespace forefront::testing {

/// Solves -Δu = f on a mesh of triangles of 6 nodes of the unit disc by isoparametric finite elements, with u = 0 at
/// the nodes of the boundary, where the exact solution is cos(π r²/2). Returns the error ‖u − u_h‖ in L² over the mesh.
double quadraticPoissonError(const MeshView &mesh);

} // namespace forefront::testing
