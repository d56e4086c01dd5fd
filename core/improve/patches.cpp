#include "core/improve/patches.hpp"

namespace forefront {

namespace {

/// Nodes of which the repair of an element may read the place: those of the elements around all nodes it may move.
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
    std::vector<NodeId> nodes; ///< some more than once

  private:
    void add(const ImproveWorkspace &work, NodeId n) {
        nodes.push_back(n);
        if (work.isFree(n)) {
            work.aroundFree(n, [&](HalfEdge h) { nodes.push_back(work.to(h)); });
        }
    }
};

} // namespace

std::vector<std::vector<std::uint32_t>> independentBatches(const ImproveWorkspace &work,
                                                           const std::vector<std::uint32_t> &elements) {
    std::vector<std::vector<std::uint32_t>> batches;
    std::vector<std::uint32_t> waiting(elements.size()), later;
    for (std::size_t i = 0; i < waiting.size(); ++i) {
        waiting[i] = static_cast<std::uint32_t>(i);
    }
    std::vector<std::uint32_t> claimed(work.mesh.nodes.size(), 0);
    Patch patch;
    for (std::uint32_t batch = 1; !waiting.empty(); ++batch) {
        later.clear();
        batches.emplace_back();
        for (const std::uint32_t i : waiting) {
            patch.take(work, elements[i]);
            bool free = true;
            for (const NodeId n : patch.nodes) {
                free = free && claimed[index(n)] != batch;
            }
            if (free) {
                batches.back().push_back(i);
                for (const NodeId n : patch.nodes) {
                    claimed[index(n)] = batch;
                }
            } else {
                later.push_back(i);
            }
        }
        waiting.swap(later);
    }
    return batches;
}

} // namespace forefront
