#include "core/engine/improve/spatial_order.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/base/key_order.hpp"
#include "core/engine/geometry/morton.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace forefront {

namespace {

constexpr std::size_t kChunk = 65536; ///< items of a task
constexpr std::uint32_t kFar = 8192;  ///< nodes, which take 128 KiB
constexpr std::size_t kMany = 16;     ///< sorting pays off if one element in this many is scattered

Element renumbered(const Element &element, const std::vector<std::uint32_t> &numbers) {
    return {NodeId{numbers[index(element[0])]}, NodeId{numbers[index(element[1])]}, NodeId{numbers[index(element[2])]}};
}

/// Calls work(k) for all k below `count`.
template <class Work>
void forEach(ThreadPool &pool, std::size_t count, const Work &work) {
    pool.forChunks(count, kChunk, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t k = begin; k < end; ++k) {
            work(k);
        }
    });
}

/// Gives item numbers[k] the place k. The list keeps its memory, so that the temporary one leaves no gap there.
template <class T>
void sortBy(ThreadPool &pool, const std::vector<std::uint32_t> &numbers, std::vector<T> &items) {
    std::vector<T> sorted(items.size());
    forEach(pool, items.size(), [&](std::size_t k) { sorted[k] = items[numbers[k]]; });
    std::copy(sorted.begin(), sorted.end(), items.begin());
}

/// Undoes sortBy().
template <class T>
void putBack(ThreadPool &pool, const std::vector<std::uint32_t> &numbers, std::vector<T> &items) {
    std::vector<T> restored(items.size());
    forEach(pool, items.size(), [&](std::size_t k) { restored[numbers[k]] = items[k]; });
    std::copy(restored.begin(), restored.end(), items.begin());
}

} // namespace

bool SpatialOrder::helps(const TriMesh &mesh) {
    const auto isFar = [](const Element &n) {
        const auto [first, last] = std::minmax({index(n[0]), index(n[1]), index(n[2])});
        return last - first > kFar;
    };
    return std::count_if(mesh.elements.begin(), mesh.elements.end(), isFar) >
           static_cast<std::ptrdiff_t>(mesh.elements.size() / kMany);
}

SpatialOrder::SpatialOrder(TriMesh &mesh, ThreadPool &pool) : mesh_(mesh), pool_(pool) {
    sortNodes();
    std::vector<std::uint32_t> rank(nodes_.size());
    forEach(pool_, nodes_.size(), [&](std::size_t k) { rank[nodes_[k]] = static_cast<std::uint32_t>(k); });
    sortElements(rank);
    renumberTagged(rank);
}

void SpatialOrder::sortNodes() {
    const Box2 box = mesh_.bounds();
    std::vector<std::uint64_t> codes(mesh_.nodes.size());
    forEach(pool_, codes.size(), [&](std::size_t n) { codes[n] = mortonCode({mesh_.nodes[n], mesh_.nodes[n]}, box); });
    nodes_ = orderByKeys(codes);
    sortBy(pool_, nodes_, mesh_.nodes);
}

/// Sorts the elements by the first of their sorted nodes; those with the same one stay in their order.
void SpatialOrder::sortElements(const std::vector<std::uint32_t> &rank) {
    const std::size_t count = mesh_.elements.size();
    std::vector<std::uint32_t> lowest(count), next(rank.size() + 1, 0);
    forEach(pool_, count, [&](std::size_t e) {
        Element &element = mesh_.elements[e];
        element = renumbered(element, rank);
        lowest[e] = static_cast<std::uint32_t>(index(*std::min_element(element.begin(), element.end())));
    });
    for (const std::uint32_t node : lowest) {
        ++next[node];
    }
    std::uint32_t first = 0;
    for (std::uint32_t &number : next) {
        first += std::exchange(number, first);
    }
    elements_.resize(count);
    for (std::uint32_t e = 0; e < count; ++e) {
        elements_[next[lowest[e]]++] = e;
    }
    sortBy(pool_, elements_, mesh_.elements);
    sortBy(pool_, elements_, mesh_.regions); // may be empty
}

void SpatialOrder::renumberTagged(const std::vector<std::uint32_t> &numbers) {
    for (TaggedEdge &edge : mesh_.edges) {
        edge.a = NodeId{numbers[index(edge.a)]};
        edge.b = NodeId{numbers[index(edge.b)]};
    }
    for (TaggedNode &point : mesh_.points) {
        point.node = NodeId{numbers[index(point.node)]};
    }
}

void SpatialOrder::restore() {
    FOREFRONT_ASSERT(mesh_.nodes.size() == nodes_.size() && mesh_.elements.size() == elements_.size());
    putBack(pool_, nodes_, mesh_.nodes);
    forEach(pool_, mesh_.elements.size(),
            [&](std::size_t k) { mesh_.elements[k] = renumbered(mesh_.elements[k], nodes_); });
    putBack(pool_, elements_, mesh_.elements);
    putBack(pool_, elements_, mesh_.regions); // may be empty
    renumberTagged(nodes_);
}

} // namespace forefront
