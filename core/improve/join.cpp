#include "core/improve/join.hpp"

#include <algorithm>
#include <atomic>
#include <memory>

namespace forefront {

namespace {

/// Marks an entry of `twin` that is the next half-edge waiting at the same node.
constexpr HalfEdge kWaiting = 0x80000000U;
constexpr HalfEdge kEnd = 0x7fffffffU;

/// One block's lists of waiting half-edges, by the lower node of their edge.
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

    /// Takes the half-edges of the block that still wait out of the lists.
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
    const Mesh &mesh_;
    std::vector<HalfEdge> heads_;
};

/// Which element of a node is noted last may depend on the threads; rings are put in an order of their own later.
void noteStart(ImproveWorkspace &work, HalfEdge h) {
    std::atomic_ref(work.start[index(work.from(h))]).store(h, std::memory_order_relaxed);
}

/// Elements of a block: few blocks, lest much is left over.
std::size_t blockSize(std::size_t elements) {
    constexpr std::size_t kLeast = 1U << 16U, kBlocks = 16;
    return std::max(kLeast, (elements + kBlocks - 1) / kBlocks);
}

void matchAll(ImproveWorkspace &work) {
    const std::size_t count = work.mesh.elements.size();
    const std::size_t size = blockSize(count);
    std::vector<std::vector<HalfEdge>> waiting((count + size - 1) / size);
    std::vector<std::unique_ptr<Matcher>> matchers(work.pool.threads());
    work.pool.run(waiting.size(), [&](std::size_t block, unsigned thread) {
        if (!matchers[thread]) {
            matchers[thread] = std::make_unique<Matcher>(work);
        }
        const auto begin = static_cast<HalfEdge>(3 * block * size);
        const auto end = static_cast<HalfEdge>(3 * std::min(count, (block + 1) * size));
        for (HalfEdge h = begin; h < end; ++h) {
            noteStart(work, h);
            matchers[thread]->add(h);
        }
        matchers[thread]->takeWaiting(begin, end, waiting[block]);
    });
    if (waiting.empty()) {
        return;
    }
    std::vector<HalfEdge> left;
    if (waiting.size() > 1) {
        Matcher &matcher = **std::find_if(matchers.begin(), matchers.end(), [](const auto &m) { return m != nullptr; });
        for (const std::vector<HalfEdge> &block : waiting) {
            for (const HalfEdge h : block) {
                matcher.add(h);
            }
        }
        for (const std::vector<HalfEdge> &block : waiting) {
            for (const HalfEdge h : block) {
                if ((work.twin[h] & kWaiting) != 0) {
                    left.push_back(h);
                }
            }
        }
    } else {
        left.swap(waiting[0]);
    }
    for (const HalfEdge h : left) {
        work.twin[h] = kNoHalfEdge;
        work.fixed[index(work.from(h))] = work.fixed[index(work.to(h))] = 1;
    }
}

void part(ImproveWorkspace &work, HalfEdge h) {
    const HalfEdge g = work.twin[h];
    work.twin[h] = work.twin[g] = kNoHalfEdge;
    work.fixed[index(work.from(h))] = work.fixed[index(work.to(h))] = 1;
}

void partRegions(ImproveWorkspace &work) {
    const Mesh &mesh = work.mesh;
    if (mesh.regions.empty()) {
        return;
    }
    for (HalfEdge h = 0; h < work.twin.size(); ++h) {
        const HalfEdge g = work.twin[h];
        if (g != kNoHalfEdge && h < g && mesh.regions[elementOf(h)] != mesh.regions[elementOf(g)]) {
            part(work, h);
        }
    }
}

/// Parts the elements at tagged edges inside. Only those whose ends are both tagged are looked at closely.
void partTagged(ImproveWorkspace &work) {
    const Mesh &mesh = work.mesh;
    const auto key = [](NodeId a, NodeId b) {
        return (static_cast<std::uint64_t>(std::min(index(a), index(b))) << 32U) | std::max(index(a), index(b));
    };
    std::vector<std::uint64_t> tagged;
    tagged.reserve(mesh.edges.size());
    for (const TaggedEdge &edge : mesh.edges) {
        tagged.push_back(key(edge.a, edge.b));
        work.fixed[index(edge.a)] = work.fixed[index(edge.b)] = 1;
    }
    for (const TaggedNode &point : mesh.points) {
        work.fixed[index(point.node)] = 1;
    }
    std::sort(tagged.begin(), tagged.end());
    for (std::size_t e = 0; e < mesh.elements.size() && !tagged.empty(); ++e) {
        const Element &n = mesh.elements[e];
        if (work.fixed[index(n[0])] + work.fixed[index(n[1])] + work.fixed[index(n[2])] < 2) {
            continue;
        }
        for (unsigned k = 0; k < 3; ++k) {
            const auto h = static_cast<HalfEdge>(3 * e + k);
            if (work.twin[h] != kNoHalfEdge &&
                std::binary_search(tagged.begin(), tagged.end(), key(n[k], n[(k + 1) % 3]))) {
                part(work, h);
            }
        }
    }
}

} // namespace

void joinElements(ImproveWorkspace &work) {
    matchAll(work);
    partRegions(work);
    partTagged(work);
}

} // namespace forefront
