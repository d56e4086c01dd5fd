#pragma once

#include "core/base/progress.hpp"
#include "core/improve/smooth.hpp"
#include "core/improve/workspace.hpp"

#include <cstddef>

namespace forefront {

/// Of the sweeps on the best level, those over the mesh and those over the surroundings of a change. From {0.45, 0.95}
/// to {0.9, 0.5} graded meshes rise from α .9897 to .9905 and fall from δ .964 to .961, discs of 10,000 elements from
/// .9958 to .9963 and from .974 to .973.
inline constexpr SmoothingAims kBestAims{0.8F, 0.6F};

struct RestructureCounts {
    std::size_t turned = 0;  ///< edges
    std::size_t merged = 0;  ///< nodes taken away
    std::size_t divided = 0; ///< nodes added
};

/// Mends nodes that have not six elements around them: tries to turn edges, merge nodes and divide nodes there, with
/// the nodes around relaxed, and keeps what brings shapes and lengths together nearer to the ideal. A change is
/// tried even where the valences alone promise nothing: such nodes come in pairs, which wander until they meet others
/// and vanish. Only free nodes come and go. No α falls below `floor`; elements that are below stay as they are.
///
/// `rho`: per node. Sites are looked at in blocks in parallel and changed one by one. All of the workspace follows but
/// α. When cancelled, the changes up to then stay.
RestructureCounts restructure(ImproveWorkspace &work, RawVector<float> rho, double floor, const Progress &progress);

} // namespace forefront
