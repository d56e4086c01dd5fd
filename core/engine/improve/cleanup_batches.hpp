#pragma once

#include "core/engine/improve/improve_workspace.hpp"

#include <vector>

namespace forefront {

/// Sorts elements into batches that can be cleaned up at the same time. The cleanup of an element reads and changes
/// only the elements around the nodes that it may move, and the nodes of these are disjoint within a batch. Cleanups
/// swap edges, so each batch is made from the mesh just before it is worked on.
class CleanupBatches {
  public:
    /// `elements`: indices of the elements to clean up; must outlive this object.
    CleanupBatches(const ImproveWorkspace &work, const std::vector<std::uint32_t> &elements);

    /// Returns the next batch as ascending positions in `elements`; empty when all elements have had their turn.
    std::vector<std::uint32_t> next();

  private:
    /// Returns true if the current batch has claimed a node that the cleanup of an element may move.
    bool touchesClaimed(std::uint32_t e) const;

    const ImproveWorkspace &work_;
    const std::vector<std::uint32_t> &elements_;
    std::vector<std::uint32_t> waiting_;
    std::vector<std::uint32_t> claimed_; ///< per node: the last batch that claimed it
    std::uint32_t batch_ = 0;
};

} // namespace forefront
