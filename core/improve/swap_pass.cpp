#include "core/improve/swap_pass.hpp"

#include <algorithm>
#include <atomic>

namespace forefront {

namespace {

template <class List>
void uniqueSorted(List &list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Swaps by blocks of consecutive elements. Threads take a block each and its edges in order, and leave for later, one
/// thread and again in order, whatever touches a node that a swap of another block or one left for later may touch. A
/// swap reads and changes only its four nodes, its two elements and links to them, so none sees the difference.
class SwapPass {
  public:
    SwapPass(ImproveWorkspace &work, const SwapRule &rule, const Progress &progress)
        : work_(work), rule_(rule), progress_(progress) {}

    std::size_t run() {
        find();
        std::size_t swaps = 0;
        for (int round = 0; round < kRounds && anyOpen() && !progress_.cancelled(); ++round) {
            forBlocks([this](Block &block) { turnInside(block); });
            turnLeft();
            forBlocks([](Block &block) {
                uniqueSorted(block.next);
                block.open.swap(block.next);
                block.next.clear();
            });
        }
        if (!progress_.cancelled()) {
            renewRings();
        }
        for (const Block &block : blocks_) {
            swaps += block.swaps;
        }
        return swaps + swapsLeft_;
    }

  private:
    static constexpr int kRounds = 6;
    static constexpr std::size_t kBlocks = 16;
    /// Where the edges to be turned are fewer than this part of the elements, one thread is as fast as several.
    static constexpr std::size_t kWorthSharing = 128;
    /// Edges between looks at the stop token.
    static constexpr std::size_t kBatch = 8192;

    struct Block {
        std::vector<HalfEdge> open, next, left;
        std::vector<NodeId> touched, claimed;
        std::size_t swaps = 0;
    };
    /// What is known of a node.
    enum class Touch : std::uint8_t {
        Inside, ///< only swaps inside one block touch it
        Shared, ///< swaps of several blocks may
        Claimed ///< as Inside, but in this round one that was left for later may touch it
    };

    std::size_t blockOf(HalfEdge h) const { return elementOf(h) / blockSize_; }
    bool between(HalfEdge h) const {
        const HalfEdge g = work_.twin[h];
        return g == kNoHalfEdge || blockOf(g) != blockOf(h);
    }

    template <class Work>
    void forBlocks(const Work &work) {
        work_.pool.run(blocks_.size(), [&](std::size_t block, unsigned) { work(blocks_[block]); });
    }
    bool anyOpen() const {
        return std::any_of(blocks_.begin(), blocks_.end(), [](const Block &block) { return !block.open.empty(); });
    }

    void find() {
        const std::size_t count = work_.mesh.elements.size();
        std::vector<std::vector<HalfEdge>> found((count + ImproveWorkspace::kChunk - 1) / ImproveWorkspace::kChunk);
        work_.pool.forChunks(
            count, ImproveWorkspace::kChunk,
            [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                findWorthTurning(work_, begin, end, rule_, found[chunk]);
            },
            progress_.stop);
        std::size_t edges = 0;
        for (const std::vector<HalfEdge> &some : found) {
            edges += some.size();
        }
        const bool shared = work_.pool.threads() > 1 && edges > count / kWorthSharing;
        blockSize_ = shared ? ImproveWorkspace::kChunk * ((found.size() + kBlocks - 1) / kBlocks)
                            : std::max<std::size_t>(1, count);
        blocks_.resize((count + blockSize_ - 1) / blockSize_);
        for (const std::vector<HalfEdge> &some : found) {
            if (!some.empty()) {
                std::vector<HalfEdge> &open = blocks_[blockOf(some.front())].open;
                open.insert(open.end(), some.begin(), some.end());
            }
        }
        if (shared) {
            markShared();
        }
    }

    /// Nodes of elements at an edge between blocks, from both sides; at an edge without a partner its ends suffice,
    /// which other blocks may reach around.
    void markShared() {
        touch_.resize(work_.mesh.nodes.size());
        work_.pool.forChunks(
            touch_.size(), ImproveWorkspace::kChunk,
            [this](std::size_t begin, std::size_t end, std::size_t) {
                std::fill(touch_.data() + begin, touch_.data() + end, Touch::Inside);
            },
            progress_.stop);
        work_.pool.run(
            blocks_.size(),
            [this](std::size_t block, unsigned) {
                const std::size_t end = std::min(work_.mesh.elements.size(), (block + 1) * blockSize_);
                markShared(static_cast<HalfEdge>(3 * block * blockSize_), static_cast<HalfEdge>(3 * end));
            },
            progress_.stop);
    }

    /// In the block of these half-edges.
    void markShared(HalfEdge begin, HalfEdge end) {
        const auto share = [this](NodeId n) {
            std::atomic_ref(touch_[index(n)]).store(Touch::Shared, std::memory_order_relaxed);
        };
        constexpr HalfEdge kAtOnce = 32; // few lead out of a block: without branches
        for (HalfEdge first = begin; first < end; first += std::min(kAtOnce, end - first)) {
            const HalfEdge last = first + std::min(kAtOnce, end - first);
            unsigned leadOut = 0;
            for (HalfEdge h = first; h < last; ++h) {
                leadOut |= work_.twin[h] - begin >= end - begin ? 1U : 0U;
            }
            for (HalfEdge h = first; leadOut != 0 && h < last; ++h) {
                const HalfEdge g = work_.twin[h];
                if (g >= begin && g < end) {
                    continue;
                }
                share(work_.from(h));
                share(work_.to(h));
                if (g != kNoHalfEdge) {
                    share(work_.apex(h));
                }
            }
        }
    }

    void turnInside(Block &block) {
        block.left.clear();
        for (std::size_t i = 0; i < block.open.size(); ++i) {
            const HalfEdge h = block.open[i];
            if (i % kBatch == 0 && progress_.cancelled()) {
                return;
            }
            if (blocks_.size() > 1 && mustWait(block, h)) {
                block.left.push_back(h);
            } else if (worthTurning(work_, h, rule_)) {
                turn(h, block.touched, block.swaps);
            }
        }
    }

    /// True, and the nodes of the block that the swap may touch are claimed for later, unless all is inside.
    bool mustWait(Block &block, HalfEdge h) {
        const HalfEdge g = work_.twin[h];
        if (g == kNoHalfEdge) {
            return false; // nothing to turn
        }
        NodeId nodes[4] = {work_.from(h), work_.to(h), work_.apex(h), work_.from(h)};
        if (!between(h)) { // else the fourth is shared, and not to be read
            nodes[3] = work_.apex(g);
        }
        if (std::all_of(std::begin(nodes), std::end(nodes),
                        [this](NodeId n) { return touch_[index(n)] == Touch::Inside; })) {
            return false;
        }
        for (const NodeId n : nodes) {
            if (touch_[index(n)] == Touch::Inside) {
                touch_[index(n)] = Touch::Claimed;
                block.claimed.push_back(n);
            }
        }
        return true;
    }

    void turn(HalfEdge h, std::vector<NodeId> &touched, std::size_t &swaps) {
        const HalfEdge g = work_.twin[h];
        const auto e0 = static_cast<HalfEdge>(3 * elementOf(h)), f0 = static_cast<HalfEdge>(3 * elementOf(g));
        touched.insert(touched.end(), {work_.from(h), work_.to(h), work_.apex(h), work_.apex(g)});
        turnEdge(work_, h);
        ++swaps;
        for (const HalfEdge first : {e0, f0}) {
            std::vector<HalfEdge> &next = blocks_[blockOf(first)].next;
            next.insert(next.end(), {first, first + 1, first + 2});
        }
    }

    /// What the blocks have left, in order.
    void turnLeft() {
        std::size_t looked = 0;
        for (Block &block : blocks_) {
            for (const HalfEdge h : block.left) {
                if (looked++ % kBatch == 0 && progress_.cancelled()) {
                    return;
                }
                if (worthTurning(work_, h, rule_)) {
                    const HalfEdge g = work_.twin[h];
                    turn(h, touchedLeft_, swapsLeft_);
                    shareAround(elementOf(h));
                    shareAround(elementOf(g));
                }
            }
        }
        for (Block &block : blocks_) {
            for (const NodeId n : block.claimed) {
                if (touch_[index(n)] == Touch::Claimed) {
                    touch_[index(n)] = Touch::Inside;
                }
            }
            block.claimed.clear();
        }
    }

    /// After a turn an element may have edges between blocks that it had not.
    void shareAround(std::size_t e) {
        for (unsigned k = 0; k < 3; ++k) {
            const auto h = static_cast<HalfEdge>(3 * e + k);
            if (work_.twin[h] != kNoHalfEdge && between(h)) {
                for (const NodeId n : {work_.from(h), work_.to(h), work_.apex(h), work_.apex(work_.twin[h])}) {
                    touch_[index(n)] = Touch::Shared;
                }
            }
        }
    }

    void renewRings() {
        const auto renew = [this](std::vector<NodeId> &nodes, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                if (work_.isFree(nodes[i])) {
                    work_.renewRing(nodes[i]);
                }
            }
        };
        forBlocks([&](Block &block) {
            uniqueSorted(block.touched);
            renew(block.touched, 0, block.touched.size());
        });
        uniqueSorted(touchedLeft_);
        work_.pool.forChunks(touchedLeft_.size(), ImproveWorkspace::kChunk,
                             [&](std::size_t begin, std::size_t end, std::size_t) { renew(touchedLeft_, begin, end); });
    }

    ImproveWorkspace &work_;
    const SwapRule &rule_;
    const Progress &progress_;
    std::size_t blockSize_ = 1;
    std::vector<Block> blocks_;
    RawVector<Touch> touch_;
    std::vector<NodeId> touchedLeft_;
    std::size_t swapsLeft_ = 0;
};

} // namespace

std::size_t swapEdges(ImproveWorkspace &work, const SwapRule &rule, const Progress &progress) {
    return SwapPass(work, rule, progress).run();
}

} // namespace forefront
