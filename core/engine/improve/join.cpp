#include "core/engine/improve/join.hpp"

#include "core/engine/base/key_order.hpp"

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>

namespace forefront {

namespace {

/// Marks an entry of `twin` that is the next half-edge waiting at the same node.
constexpr HalfEdge kWaiting = 0x80000000U;
constexpr HalfEdge kEnd = 0x7fffffffU;

/// Lists of the waiting half-edges of a block, by the lower node of their edge.
class Matcher {
  public:
    explicit Matcher(ImproveWorkspace &work) : work_(work), mesh_(work.mesh), heads_(mesh_.nodes.size(), kEnd) {}

    void add(HalfEdge h) {
        const NodeId a = work_.from(h), b = work_.to(h);
        HalfEdge *link = &heads_[std::min(index(a), index(b))];
        bool marked = false;
        for (HalfEdge g = *link; g != kEnd;) {
            HalfEdge *const entry = &work_.twin[g];
            if (work_.from(g) == b && work_.to(g) == a) {
                *link = marked ? *entry : *entry & ~kWaiting;
                work_.twin[g] = h;
                work_.twin[h] = g;
                return;
            }
            link = entry;
            marked = true;
            g = *entry & ~kWaiting;
        }
        HalfEdge &head = heads_[std::min(index(a), index(b))];
        work_.twin[h] = head | kWaiting;
        head = h;
    }

    /// Moves the half-edges of the block that are still waiting from the lists to `waiting`.
    void takeWaiting(HalfEdge begin, HalfEdge end, std::vector<HalfEdge> &waiting) {
        for (HalfEdge h = begin; h < end; ++h) {
            if ((work_.twin[h] & kWaiting) != 0) {
                waiting.push_back(h);
                heads_[std::min(index(work_.from(h)), index(work_.to(h)))] = kEnd;
            }
        }
    }

  private:
    ImproveWorkspace &work_;
    const TriMesh &mesh_;
    std::vector<HalfEdge> heads_;
};

/// Notes a half-edge that starts at a node. Which one is noted last may depend on the threads; beginRing() later makes
/// the start independent of them.
void noteStart(ImproveWorkspace &work, HalfEdge h) {
    std::atomic_ref(work.start[index(work.from(h))]).store(h, std::memory_order_relaxed);
}

/// Returns the number of elements of a block. There are few blocks, so that little is left to match across them.
std::size_t blockSize(std::size_t elements) {
    constexpr std::size_t kMinBlock = 1U << 16U, kBlocks = 16;
    return std::max(kMinBlock, (elements + kBlocks - 1) / kBlocks);
}

void clearNodes(ImproveWorkspace &work, const std::stop_token &stop) {
    work.pool.forChunks(
        work.start.size(), ImproveWorkspace::kChunk,
        [&work](std::size_t begin, std::size_t end, std::size_t) {
            std::fill(work.start.data() + begin, work.start.data() + end, kNoHalfEdge);
            std::fill(work.fixed.data() + begin, work.fixed.data() + end, std::uint8_t{0});
        },
        stop);
}

/// Half-edges between checks for cancellation: about a millisecond.
constexpr HalfEdge kBatch = 1U << 16U;

/// Matches the half-edges of a block and returns those without a partner in it.
std::vector<HalfEdge> matchBlock(ImproveWorkspace &work, Matcher &matcher, HalfEdge begin, HalfEdge end,
                                 const std::stop_token &stop) {
    std::vector<HalfEdge> waiting;
    for (HalfEdge from = begin; from < end && !stop.stop_requested(); from += std::min(kBatch, end - from)) {
        for (HalfEdge h = from; h < from + std::min(kBatch, end - from); ++h) {
            noteStart(work, h);
            matcher.add(h);
        }
    }
    if (!stop.stop_requested()) {
        matcher.takeWaiting(begin, end, waiting);
    }
    return waiting;
}

void matchAll(ImproveWorkspace &work, const std::stop_token &stop) {
    const std::size_t count = work.mesh.elements.size();
    const std::size_t size = blockSize(count);
    std::vector<std::vector<HalfEdge>> waiting((count + size - 1) / size);
    std::vector<std::unique_ptr<Matcher>> matchers(work.pool.threads());
    work.pool.run(
        waiting.size(),
        [&](std::size_t block, unsigned thread) {
            if (!matchers[thread]) {
                matchers[thread] = std::make_unique<Matcher>(work);
            }
            waiting[block] = matchBlock(work, *matchers[thread], static_cast<HalfEdge>(3 * block * size),
                                        static_cast<HalfEdge>(3 * std::min(count, (block + 1) * size)), stop);
        },
        stop);
    if (waiting.empty() || stop.stop_requested()) {
        return;
    }
    Matcher &matcher = **std::find_if(matchers.begin(), matchers.end(), [](const auto &m) { return m != nullptr; });
    if (waiting.size() > 1) {
        for (const std::vector<HalfEdge> &block : waiting) {
            for (const HalfEdge h : block) {
                matcher.add(h);
            }
        }
    }
    for (const std::vector<HalfEdge> &block : waiting) {
        for (const HalfEdge h : block) {
            if ((work.twin[h] & kWaiting) != 0) {
                work.twin[h] = kNoHalfEdge;
                work.fixed[index(work.from(h))] = work.fixed[index(work.to(h))] = 1;
            }
        }
    }
}

void separate(ImproveWorkspace &work, HalfEdge h) {
    const HalfEdge g = work.twin[h];
    work.twin[h] = work.twin[g] = kNoHalfEdge;
    work.fixed[index(work.from(h))] = work.fixed[index(work.to(h))] = 1;
}

/// Lists the tagged edges by their nodes, and fixes these nodes.
class TaggedEdges {
  public:
    explicit TaggedEdges(ImproveWorkspace &work) {
        keys_.reserve(work.mesh.edges.size());
        for (const TaggedEdge &edge : work.mesh.edges) {
            keys_.push_back(pairKey(std::min(edge.a, edge.b), std::max(edge.a, edge.b)));
            work.fixed[index(edge.a)] = work.fixed[index(edge.b)] = 1;
        }
        for (const TaggedNode &point : work.mesh.points) {
            work.fixed[index(point.node)] = 1;
        }
        std::sort(keys_.begin(), keys_.end());
    }
    bool contain(NodeId a, NodeId b) const {
        return std::binary_search(keys_.begin(), keys_.end(), pairKey(std::min(a, b), std::max(a, b)));
    }

  private:
    std::vector<std::uint64_t> keys_;
};

/// Separates the elements at tagged edges and between regions. Both ends of a tagged edge are fixed.
void separateTagged(ImproveWorkspace &work, const std::stop_token &stop) {
    const TriMesh &mesh = work.mesh;
    const TaggedEdges tagged(work);
    const std::size_t count = mesh.elements.size();
    const bool manyRegions =
        std::adjacent_find(mesh.regions.begin(), mesh.regions.end(), std::not_equal_to<>()) != mesh.regions.end();
    std::vector<std::vector<HalfEdge>> found((count + ImproveWorkspace::kChunk - 1) / ImproveWorkspace::kChunk);
    work.pool.forChunks(
        count, ImproveWorkspace::kChunk,
        [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            for (std::size_t e = begin; e < end; ++e) {
                const Element &n = mesh.elements[e];
                const bool mayBeTagged =
                    work.fixed[index(n[0])] + work.fixed[index(n[1])] + work.fixed[index(n[2])] >= 2;
                for (unsigned k = 0; k < 3 && (mayBeTagged || manyRegions); ++k) {
                    const auto h = static_cast<HalfEdge>(3 * e + k);
                    const HalfEdge g = work.twin[h];
                    if (g != kNoHalfEdge && h < g &&
                        (mesh.region(e) != mesh.region(elementOf(g)) ||
                         (mayBeTagged && tagged.contain(n[k], n[(k + 1) % 3])))) {
                        found[chunk].push_back(h);
                    }
                }
            }
        },
        stop);
    for (const std::vector<HalfEdge> &some : found) {
        for (const HalfEdge h : some) {
            separate(work, h);
        }
    }
}

} // namespace

void joinElements(ImproveWorkspace &work, const std::stop_token &stop) {
    clearNodes(work, stop);
    matchAll(work, stop);
    if (!stop.stop_requested()) {
        separateTagged(work, stop);
    }
}

} // namespace forefront
