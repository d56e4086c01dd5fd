#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

#include <array>
#include <span>
#include <vector>

namespace forefront {

/// Returns the gradient of the linear interpolation of nodal values, constant on each element; zero on elements with
/// zero area. Error: "cancelled".
Result<std::vector<Vec2>> elementGradients(const TriMesh &mesh, std::span<const double> values,
                                           const Progress &progress = {});

/// A recovered gradient, linear on each element: one value per element and corner.
using CornerGradients = std::vector<std::array<Vec2, 3>>;

/// Recovers a gradient by superconvergent patch recovery (O. C. Zienkiewicz and J. Z. Zhu, "The superconvergent patch
/// recovery and a posteriori error estimates", Int. J. Numer. Meth. Engng 33 (1992)): at each node a linear function is
/// fitted by least squares to the gradients at the centroids of the elements around it and evaluated at the node.
/// Patches at the boundary, with too few elements for a fit, include the next ring. Where no fit is possible, the
/// result is the area-weighted mean. Patches never cross the border between regions, where a gradient may jump.
/// `gradients`: one per element. Error: "cancelled".
Result<CornerGradients> recoverGradient(const TriMesh &mesh, std::span<const Vec2> gradients,
                                        const Progress &progress = {});

} // namespace forefront
