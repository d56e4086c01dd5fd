#include "core/files/gmsh/msh_file.hpp"

#include <algorithm>
#include <numeric>

namespace forefront {

namespace {

/// Marks the items whose key an earlier item has.
template <class Key>
std::vector<std::uint8_t> repeatedItems(const std::vector<Key> &keys) {
    std::vector<std::uint32_t> order(keys.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return keys[a] != keys[b] ? keys[a] < keys[b] : a < b; });
    std::vector<std::uint8_t> repeated(keys.size(), 0);
    for (std::size_t k = 1; k < order.size(); ++k) {
        repeated[order[k]] = keys[order[k]] == keys[order[k - 1]] ? 1 : 0;
    }
    return repeated;
}

template <class T>
void dropMarked(std::vector<T> &items, const std::vector<std::uint8_t> &marked) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < items.size(); ++k) {
        if (marked[k] == 0) {
            items[kept++] = items[k];
        }
    }
    items.resize(kept);
}

} // namespace

/// MSH 2 lists a line or triangle once for each physical group that it is in. Keeps the first.
void MshFile::dropRepeats() {
    TriMesh &mesh = builder_.mesh;
    const auto differ = [](const auto &items, auto tagOf) {
        return std::any_of(items.begin(), items.end(),
                           [&](const auto &item) { return tagOf(item) != tagOf(items.front()); });
    };
    std::size_t dropped = 0;
    if (differ(mesh.regions, [](std::int32_t region) { return region; })) {
        std::vector<Element> keys = mesh.elements;
        for (Element &key : keys) {
            std::sort(key.begin(), key.end());
        }
        const std::vector<std::uint8_t> repeated = repeatedItems(keys);
        dropped += static_cast<std::size_t>(std::count(repeated.begin(), repeated.end(), 1));
        dropMarked(mesh.elements, repeated);
        dropMarked(mesh.regions, repeated);
        dropMarked(elementNumbers_, repeated);
        dropMarked(elementPartitions_, repeated);
        for (MshValues &field : elementValues_) {
            dropMarked(field.values, repeated);
        }
    }
    if (differ(mesh.edges, [](const TaggedEdge &edge) { return edge.tag; })) {
        std::vector<std::pair<NodeId, NodeId>> keys;
        keys.reserve(mesh.edges.size());
        for (const TaggedEdge &edge : mesh.edges) {
            keys.emplace_back(std::min(edge.a, edge.b), std::max(edge.a, edge.b));
        }
        const std::vector<std::uint8_t> repeated = repeatedItems(keys);
        dropped += static_cast<std::size_t>(std::count(repeated.begin(), repeated.end(), 1));
        dropMarked(mesh.edges, repeated);
    }
    if (dropped > 0) {
        scanner_.source().note("several-groups",
                               "lines and triangles in several physical groups are kept once, in the first",
                               elementsOffset_, dropped);
    }
}

} // namespace forefront
