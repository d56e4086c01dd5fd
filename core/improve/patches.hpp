#pragma once

#include "core/improve/workspace.hpp"

#include <vector>

namespace forefront {

/// Sorts elements into batches whose repairs do not touch each other: each reads and changes only places, elements and
/// neighbours among the nodes of the elements around the nodes that it may move, and these are disjoint within a batch.
/// A repair may turn edges, so each batch is made from the mesh as it is just before.
class RepairBatches {
  public:
    /// `elements`: to be repaired, by index; must outlive this.
    RepairBatches(const ImproveWorkspace &work, const std::vector<std::uint32_t> &elements);

    /// Places in `elements` that make the next batch, in rising order; empty when all have had their turn.
    std::vector<std::uint32_t> next();

  private:
    const ImproveWorkspace &work_;
    const std::vector<std::uint32_t> &elements_;
    std::vector<std::uint32_t> waiting_;
    std::vector<std::uint32_t> claimed_; ///< per node: the batch that last claimed it
    std::uint32_t batch_ = 0;
};

} // namespace forefront
