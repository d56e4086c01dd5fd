#pragma once

#include "core/improve/workspace.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Remembers which cleanups of elements changed nothing, so that none is repeated before something around it has
/// changed. The cleanup of an element reads and changes only the elements around the nodes that it may move: its own,
/// and those of the elements beside it.
class VainAttempts {
  public:
    explicit VainAttempts(const ImproveWorkspace &work)
        : work_(work), changedAt_(work.mesh.nodes.size(), 0), failedAt_(work.mesh.elements.size(), 0) {}

    /// Call after each batch of cleanups, before record().
    void beginBatch() { ++now_; }
    /// Records the result of a cleanup of the last batch.
    void record(std::size_t e, bool changed) {
        if (changed) {
            forMovable(e, [&](NodeId n) { changedAt_[index(n)] = now_; });
        } else {
            failedAt_[e] = now_;
        }
    }
    /// Returns true if the last cleanup of an element changed nothing and another one would not either.
    bool isVain(std::size_t e) const {
        const std::uint32_t failed = failedAt_[e];
        bool vain = failed > 0;
        const auto look = [&](NodeId n) { vain = vain && changedAt_[index(n)] < failed; };
        if (vain) {
            forMovable(e, [&](NodeId n) {
                look(n);
                if (vain && work_.isFree(n)) {
                    work_.aroundFree(n, [&](HalfEdge h) { look(work_.to(h)); });
                }
            });
        }
        return vain;
    }

  private:
    template <class Visit>
    void forMovable(std::size_t e, const Visit &visit) const {
        for (unsigned k = 0; k < 3; ++k) {
            const auto h = static_cast<HalfEdge>(3 * e + k);
            visit(work_.from(h));
            if (const HalfEdge g = work_.twin[h]; g != kNoHalfEdge) {
                visit(work_.apex(g));
            }
        }
    }

    const ImproveWorkspace &work_;
    std::vector<std::uint32_t> changedAt_; ///< per node: the last batch that may have moved it or swapped an edge of it
    std::vector<std::uint32_t> failedAt_;  ///< per element: the batch of its last cleanup, if that changed nothing
    std::uint32_t now_ = 0;
};

} // namespace forefront
