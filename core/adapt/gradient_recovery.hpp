#pragma once

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/mesh/mesh.hpp"

#include <array>
#include <span>
#include <vector>

namespace forefront {

/// Gradient of the linear interpolation of nodal values, constant on each element; zero on elements without area.
/// Fault: "cancelled".
Result<std::vector<Vec2>> elementGradients(const Mesh &mesh, std::span<const double> values,
                                           const Progress &progress = {});

/// A continuous gradient, recovered at the corners of the elements: per element and corner, linear between.
using CornerGradients = std::vector<std::array<Vec2, 3>>;

/// Superconvergent patch recovery after O. C. Zienkiewicz and J. Z. Zhu, "The superconvergent patch recovery and a
/// posteriori error estimates", Int. J. Numer. Meth. Engng 33 (1992): at each node a linear function is fitted by least
/// squares to the gradients at the centroids of the elements around it, and taken at the node. Patches at the boundary,
/// which have too few elements for a fit, take in the next ring. Where elements lie so that there is no fit, the mean
/// weighted by area. Never across the border between regions, where a gradient may rightly jump. `gradients`: of the
/// elements. Fault: "cancelled".
Result<CornerGradients> recoverGradient(const Mesh &mesh, std::span<const Vec2> gradients,
                                        const Progress &progress = {});

} // namespace forefront
