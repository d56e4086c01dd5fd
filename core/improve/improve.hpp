#pragma once

#include "core/base/progress.hpp"
#include "core/mesh/mesh.hpp"

namespace forefront {

struct ImproveOptions {
    int rounds = 3; ///< swap and smooth rounds; 0 leaves the mesh as it is
};

struct ImproveReport {
    std::size_t swaps = 0;
    std::size_t moves = 0;
    double alphaMinBefore = 0.0;
    double alphaMinAfter = 0.0; ///< never less than before
};

/// Edge swapping and node smoothing in place. Nodes of tagged edges and tagged points do not move, tagged edges are not
/// swapped, no element becomes inverted or flat (exact sign), the least α never falls. Deterministic. Cancelling leaves
/// a valid mesh.
ImproveReport improve(Mesh &mesh, const ImproveOptions &options = {}, const Progress &progress = {});

} // namespace forefront
