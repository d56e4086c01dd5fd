#pragma once

#include "core/engine/adapt/error_estimate.hpp"
#include "core/engine/base/api.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <limits>
#include <span>
#include <vector>

namespace FOREFRONT_API forefront {

/// The target of an adapted mesh.
struct AdaptTarget {
    double error = 0.05;  ///< target of ErrorEstimate::relative()
    double sizeMin = 0.0; ///< minimum node spacing; may keep the error above its target
    double sizeMax = std::numeric_limits<double>::infinity();
    double gradation = 0.3; ///< maximum change of node spacing per unit of distance
};

/// Returns the spacing of each element that meets the target with the fewest elements. The error of a linear element of
/// size h falls as h², so h_new = h·√(e_target/e), where e_target is the same for all elements and follows from the
/// total. One step changes h by a factor between 1/6 and 3, since estimates on coarse meshes are inaccurate. Error:
/// "cancelled".
Result<std::vector<double>> elementSpacing(const TriMesh &mesh, const ErrorEstimate &estimate,
                                           const AdaptTarget &target, const Progress &progress = {});

/// Converts element spacings to nodal spacings: the mean of the density 1/h² around each node, weighted by area.
std::vector<double> nodalSpacing(const TriMesh &mesh, std::span<const double> elementSpacing);

/// Calls the two functions above, limits the gradation, and returns the node spacing with `mesh` as background mesh.
/// Error: "cancelled".
Result<SpacingSpec> adaptedSpacing(const TriMesh &mesh, const ErrorEstimate &estimate, const AdaptTarget &target,
                                   const Progress &progress = {});

} // namespace forefront
