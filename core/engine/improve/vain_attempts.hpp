#pragma once

#include "core/engine/improve/cleanup_region.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Remembers which cleanups of elements changed nothing, so that none is repeated before something it reads has
/// changed.
class VainAttempts {
  public:
    explicit VainAttempts(const ImproveWorkspace &work)
        : work_(work), changedAt_(work.mesh.nodes.size(), 0), failedAt_(work.mesh.elements.size(), 0) {}

    /// Records a batch of cleanups after its end. `batch`: positions in `elements`; `changed`: by position, not 0 where
    /// a cleanup changed something.
    void record(const std::vector<std::uint32_t> &batch, const std::vector<std::uint32_t> &elements,
                const std::vector<std::uint8_t> &changed) {
        ++batch_;
        for (const std::uint32_t i : batch) {
            if (changed[i] != 0) {
                forMovableNodes(work_, elements[i], [&](NodeId n) { changedAt_[index(n)] = batch_; });
            } else {
                failedAt_[elements[i]] = batch_;
            }
        }
    }
    /// Returns true if the last cleanup of an element changed nothing and a repeat would not either. Threads may call
    /// it at the same time.
    bool isVain(std::size_t e) const {
        const std::uint32_t failed = failedAt_[e];
        bool vain = failed > 0;
        if (vain) {
            forReadNodes(work_, e, [&](NodeId n) { vain = vain && changedAt_[index(n)] < failed; });
        }
        return vain;
    }

  private:
    const ImproveWorkspace &work_;
    std::vector<std::uint32_t> changedAt_; ///< per node: the last batch that may have moved it or swapped an edge of it
    std::vector<std::uint32_t> failedAt_;  ///< per element: the batch of its last cleanup, if that changed nothing
    std::uint32_t batch_ = 0;
};

} // namespace forefront
