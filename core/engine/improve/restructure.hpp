#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/improve/improve_workspace.hpp"
#include "core/engine/improve/smooth.hpp"

#include <cstddef>

namespace forefront {

/// The aims of smoothing on level Best, over the mesh and around a change. From {0.45, 0.95} to {0.9, 0.5} α rises from
/// .9897 to .9905 and δ falls from .964 to .961 on graded meshes; on discs of 10,000 elements α rises from .9958 to
/// .9963 and δ falls from .974 to .973.
inline constexpr SmoothingAims kBestAims{0.8F, 0.6F};

/// The result of restructure().
struct RestructureCounts {
    std::size_t swapped = 0; ///< edges
    std::size_t merged = 0;  ///< nodes removed
    std::size_t divided = 0; ///< nodes added
};

/// Reduces the number of nodes that do not have six elements around them. At each it tries to swap edges, merge nodes
/// and divide nodes, relaxes the nodes around, and keeps a change that improves shapes and lengths together. It also
/// tries changes that do not improve the valences: irregular nodes come in pairs, which wander until they meet others
/// and vanish. Only free nodes are added or removed. No α falls below `floor`, and elements below it do not change.
///
/// `rho`: ρ per node. Sites are examined in parallel, in blocks, and changed one by one. Updates the workspace except
/// α. When cancelled, the changes made so far remain.
RestructureCounts restructure(ImproveWorkspace &work, RawVector<float> rho, double floor, const Progress &progress);

} // namespace forefront
