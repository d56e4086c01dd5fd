#include "core/engine/improve/cleanup_batches.hpp"

#include "core/engine/improve/cleanup_region.hpp"

#include <algorithm>
#include <numeric>

namespace forefront {

CleanupBatches::CleanupBatches(const ImproveWorkspace &work, const std::vector<std::uint32_t> &elements)
    : work_(work), elements_(elements), waiting_(elements.size()), claimed_(work.mesh.nodes.size(), 0) {
    std::iota(waiting_.begin(), waiting_.end(), 0U);
}

std::vector<std::uint32_t> CleanupBatches::next() {
    std::vector<std::uint32_t> batch, later;
    ++batch_;
    std::vector<NodeId> nodes; // with repeats
    for (const std::uint32_t i : waiting_) {
        if (touchesClaimed(elements_[i])) { // most of those that have to wait
            later.push_back(i);
            continue;
        }
        nodes.clear();
        forReadNodes(work_, elements_[i], [&](NodeId n) { nodes.push_back(n); });
        const bool free =
            std::none_of(nodes.begin(), nodes.end(), [&](NodeId n) { return claimed_[index(n)] == batch_; });
        (free ? batch : later).push_back(i);
        for (const NodeId n : nodes) {
            claimed_[index(n)] = free ? batch_ : claimed_[index(n)];
        }
    }
    waiting_.swap(later);
    return batch;
}

bool CleanupBatches::touchesClaimed(std::uint32_t e) const {
    bool touches = false;
    forMovableNodes(work_, e, [&](NodeId n) { touches = touches || claimed_[index(n)] == batch_; });
    return touches;
}

} // namespace forefront
