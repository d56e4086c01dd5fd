#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/mesh/tri_mesh.hpp"

#include <span>
#include <vector>

namespace FOREFRONT_API forefront {

/// The estimated error of the gradient of a nodal field in the L2 norm (for Poisson's equation, the energy norm).
struct ErrorEstimate {
    std::vector<double> elements; ///< ‖G − ∇u‖ over each element
    double total = 0.0;           ///< over the mesh: root of the sum of squares
    double norm = 0.0;            ///< ‖∇u‖ over the mesh

    /// Returns total / √(norm² + total²), between 0 and 1; 0 for a constant field.
    double relative() const;
};

/// Estimates the error by the method of O. C. Zienkiewicz and J. Z. Zhu (1987, 1992), with the recovered gradient G in
/// place of the exact one. Error: "cancelled".
Result<ErrorEstimate> estimateError(const TriMesh &mesh, std::span<const double> values, const Progress &progress = {});

} // namespace forefront
