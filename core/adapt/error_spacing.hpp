#pragma once

#include "core/adapt/error_estimate.hpp"
#include "core/base/api.hpp"
#include "core/spacing/spec/spacing_spec.hpp"

#include <limits>
#include <span>
#include <vector>

namespace FOREFRONT_API forefront {

/// What an adapted mesh shall be like.
struct AdaptTarget {
    double error = 0.05;  ///< wanted ErrorEstimate::relative()
    double sizeMin = 0.0; ///< no node spacing below; where the error asks for less, it stays above the wanted one
    double sizeMax = std::numeric_limits<double>::infinity();
    double gradation = 0.3; ///< greatest change of node spacing per unit of distance
};

/// Spacing of each element that meets the target with the fewest elements: the error of a linear element of size h
/// falls as h², so that h_new = h·√(e_target/e) with the same e_target for all; e_target follows from the total. One
/// step changes h by a factor between 1/6 and 3, since an estimate on a coarse mesh is a coarse one. Fault:
/// "cancelled".
Result<std::vector<double>> elementSpacing(const Mesh &mesh, const ErrorEstimate &estimate, const AdaptTarget &target,
                                           const Progress &progress = {});

/// From elements to nodes: the mean of the density 1/h² around each node, weighted by area.
std::vector<double> nodalSpacing(const Mesh &mesh, std::span<const double> elementSpacing);

/// Lowers nodal spacings so that along no edge they grow by more than `gradation` per unit of length. O(n log n).
/// False when cancelled.
bool limitGradation(const Mesh &mesh, double gradation, std::span<double> spacing, const Progress &progress = {});

/// The three steps: node spacing on `mesh` as background mesh. Fault: "cancelled".
Result<SpacingSpec> adaptedSpacing(const Mesh &mesh, const ErrorEstimate &estimate, const AdaptTarget &target,
                                   const Progress &progress = {});

} // namespace forefront
