#include "core/improve/cleanup_batches.hpp"

#include <algorithm>
#include <numeric>

namespace forefront {

namespace {

/// The nodes whose positions the cleanup of an element may read: those of the elements around all nodes it may move.
class Patch {
  public:
    void take(const ImproveWorkspace &work, std::size_t e) {
        nodes.clear();
        for (unsigned k = 0; k < 3; ++k) {
            const auto h = static_cast<HalfEdge>(3 * e + k);
            add(work, work.from(h));
            if (work.twin[h] != kNoHalfEdge) {
                add(work, work.apex(work.twin[h]));
            }
        }
    }
    std::vector<NodeId> nodes; ///< with repeats

  private:
    void add(const ImproveWorkspace &work, NodeId n) {
        nodes.push_back(n);
        if (work.isFree(n)) {
            work.aroundFree(n, [&](HalfEdge h) { nodes.push_back(work.to(h)); });
        }
    }
};

} // namespace

CleanupBatches::CleanupBatches(const ImproveWorkspace &work, const std::vector<std::uint32_t> &elements)
    : work_(work), elements_(elements), waiting_(elements.size()), claimed_(work.mesh.nodes.size(), 0) {
    std::iota(waiting_.begin(), waiting_.end(), 0U);
}

std::vector<std::uint32_t> CleanupBatches::next() {
    std::vector<std::uint32_t> batch, later;
    ++batch_;
    Patch patch;
    for (const std::uint32_t i : waiting_) {
        patch.take(work_, elements_[i]);
        const bool free = std::none_of(patch.nodes.begin(), patch.nodes.end(),
                                       [&](NodeId n) { return claimed_[index(n)] == batch_; });
        (free ? batch : later).push_back(i);
        for (const NodeId n : patch.nodes) {
            claimed_[index(n)] = free ? batch_ : claimed_[index(n)];
        }
    }
    waiting_.swap(later);
    return batch;
}

} // namespace forefront
