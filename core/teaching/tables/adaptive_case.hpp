#pragma once

#include "core/engine/adapt/adaptive_meshing.hpp"
#include "core/teaching/tables/table_case.hpp"

#include <cstddef>
#include <string>

namespace forefront {

/// A problem of our own that stands in for a published row of adaptive refinement, of which only the number of boundary
/// nodes, the minimum node spacing and the size of the mesh are known.
struct AdaptiveCase {
    Domain domain;
    std::string field;  ///< expression in x and y
    AdaptTarget target; ///< its minimum size is the row's ρmin
};

/// Returns the problem of row 3 or 4:
///   3: an L; the singular field of its re-entrant corner with fronts that meet the walls.
///   4: a rectangle with a round hole; fronts around the hole, away from the boundary.
AdaptiveCase adaptiveCase(const TableCase &row);

/// The job that results from adaptive refinement: the node spacing of its last round, the classic method, no
/// improvement.
struct AdaptedJob {
    MeshingJob job;
    std::size_t rounds = 0; ///< new meshes until the estimate met the target
};

/// Meshes the case with default options and refines it until the estimated error of the field meets the target. Faults:
/// "not-met", and those of `adapt`.
Result<AdaptedJob> adaptToTarget(const AdaptiveCase &problem, const NodalField &field, const Progress &progress = {});

} // namespace forefront
