#include "core/files/gmsh/msh_file.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

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

/// Returns the corners of each element in the order of their indices; those of a triangle end with kNoNode.
std::vector<std::array<NodeId, kMaxCellCorners>> sortedCorners(const ElementList &elements) {
    std::vector<std::array<NodeId, kMaxCellCorners>> keys(elements.size());
    for (std::size_t e = 0; e < keys.size(); ++e) {
        keys[e].fill(kNoNode);
        const std::span<const NodeId> corners = elements.cornersOf(e);
        std::copy(corners.begin(), corners.end(), keys[e].begin());
        std::sort(keys[e].begin(), keys[e].end());
    }
    return keys;
}

} // namespace

/// MSH 2 lists a line or element once for each physical group that it is in. Keeps the first.
void MshFile::dropRepeats() {
    Mesh &mesh = builder_.mesh;
    ElementList &elements = builder_.elements;
    const auto differ = [](const auto &items, auto tagOf) {
        return std::any_of(items.begin(), items.end(),
                           [&](const auto &item) { return tagOf(item) != tagOf(items.front()); });
    };
    std::size_t dropped = 0;
    if (differ(elements.regions, [](std::int32_t region) { return region; })) {
        const std::vector<std::uint8_t> repeated = repeatedItems(sortedCorners(elements));
        dropped += static_cast<std::size_t>(std::count(repeated.begin(), repeated.end(), 1));
        std::vector<std::uint32_t> kept;
        for (std::uint32_t e = 0; e < repeated.size(); ++e) {
            if (repeated[e] == 0) {
                kept.push_back(e);
            }
        }
        elements.arrange(kept);
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
                               "lines and elements in several physical groups are kept once, in the first",
                               elementsOffset_, dropped);
    }
}

} // namespace forefront
