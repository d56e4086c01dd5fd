#include "core/engine/improve/swap_pass.hpp"

#include <algorithm>
#include <array>

namespace forefront {

namespace {

template <class List>
void uniqueSorted(List &list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Swaps edges one after the other on one thread; threads share the search for edges and the rings of nodes.
///
/// Swaps in blocks of elements on several threads, with those near other blocks left for later, saved nothing that
/// could be measured on two threads (2 % of the edges of a mesh are swapped at most) and did not always give the mesh
/// of one thread: a swap that waits can grow to reach a node that a later swap has already changed.
class SwapPass {
  public:
    SwapPass(ImproveWorkspace &work, const SwapRule &rule, const Progress &progress)
        : work_(work), rule_(rule), progress_(progress) {}

    std::size_t run() {
        findFirst();
        for (int round = 0; round < kRounds && !open_.empty() && !progress_.cancelled(); ++round) {
            swapOpen();
            uniqueSorted(next_);
            open_.swap(next_);
            next_.clear();
        }
        if (!progress_.cancelled()) {
            renewRings();
        }
        return swaps_;
    }

  private:
    static constexpr int kRounds = 6;
    /// Number of edges between checks for cancellation.
    static constexpr std::size_t kBatch = 8192;
    /// Number of nodes per task that renews rings.
    static constexpr std::size_t kRingChunk = 1024;

    void findFirst() {
        const std::size_t count = work_.mesh.elements.size();
        std::vector<std::vector<HalfEdge>> found((count + ImproveWorkspace::kChunk - 1) / ImproveWorkspace::kChunk);
        work_.pool.forChunks(
            count, ImproveWorkspace::kChunk,
            [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                findWorthSwapping(work_, begin, end, rule_, found[chunk]);
            },
            progress_.stop);
        for (const std::vector<HalfEdge> &some : found) {
            open_.insert(open_.end(), some.begin(), some.end());
        }
    }

    void swapOpen() {
        for (std::size_t i = 0; i < open_.size(); ++i) {
            if (i % kBatch == 0 && progress_.cancelled()) {
                return;
            }
            if (worthSwapping(work_, open_[i], rule_)) {
                swap(open_[i]);
            }
        }
    }

    void swap(HalfEdge h) {
        const HalfEdge g = work_.twin[h];
        touched_.insert(touched_.end(), {work_.from(h), work_.to(h), work_.apex(h), work_.apex(g)});
        swapEdge(work_, h);
        ++swaps_;
        if (work_.watch != nullptr) {
            const std::array changed = {static_cast<std::uint32_t>(elementOf(h)),
                                        static_cast<std::uint32_t>(elementOf(g))};
            work_.report(ImproveChange::Swap, {.all = false, .elements = changed});
        }
        for (const std::size_t e : {elementOf(h), elementOf(g)}) {
            const auto first = static_cast<HalfEdge>(3 * e);
            next_.insert(next_.end(), {first, first + 1, first + 2});
        }
    }

    void renewRings() {
        uniqueSorted(touched_);
        work_.pool.forChunks(touched_.size(), kRingChunk, [this](std::size_t begin, std::size_t end, std::size_t) {
            for (std::size_t i = begin; i < end; ++i) {
                if (work_.isFree(touched_[i])) {
                    work_.renewRing(touched_[i]);
                }
            }
        });
    }

    ImproveWorkspace &work_;
    const SwapRule &rule_;
    const Progress &progress_;
    std::vector<HalfEdge> open_, next_; ///< edges to examine in this round and in the next
    std::vector<NodeId> touched_;       ///< nodes whose rings are out of date
    std::size_t swaps_ = 0;
};

} // namespace

std::size_t swapEdges(ImproveWorkspace &work, const SwapRule &rule, const Progress &progress) {
    return SwapPass(work, rule, progress).run();
}

} // namespace forefront
