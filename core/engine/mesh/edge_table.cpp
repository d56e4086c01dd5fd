#include "core/engine/mesh/edge_table.hpp"

#include <algorithm>

namespace forefront {

std::uint32_t EdgeTable::lowerNode(HalfEdge h) const {
    return static_cast<std::uint32_t>(std::min(startOf(*mesh_, h), endOf(*mesh_, h)));
}

std::uint32_t EdgeTable::upperNode(HalfEdge h) const {
    return static_cast<std::uint32_t>(std::max(startOf(*mesh_, h), endOf(*mesh_, h)));
}

EdgeTable::EdgeTable(const TriMesh &mesh)
    : mesh_(&mesh), offsets_(mesh.nodes.size() + 1, 0), halfEdges_(3 * mesh.elements.size()) {
    for (const Element &e : mesh.elements) {
        ++offsets_[index(std::min(e[0], e[1]))];
        ++offsets_[index(std::min(e[1], e[2]))];
        ++offsets_[index(std::min(e[2], e[0]))];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t &offset : offsets_) {
        sum += offset;
        offset = sum;
    }
    // Filled from the back, so that each row is ascending and its offset ends at its first entry.
    for (HalfEdge h = static_cast<HalfEdge>(halfEdges_.size()); h-- > 0;) {
        halfEdges_[--offsets_[lowerNode(h)]] = h;
    }
    for (std::size_t n = 0; n + 1 < offsets_.size(); ++n) {
        sortRow(offsets_[n], offsets_[n + 1]);
    }
}

void EdgeTable::sortRow(std::uint32_t begin, std::uint32_t end) {
    constexpr std::uint32_t kShort = 24;
    if (end - begin > kShort) {
        std::sort(halfEdges_.begin() + begin, halfEdges_.begin() + end, [this](HalfEdge a, HalfEdge b) {
            const std::uint32_t ua = upperNode(a), ub = upperNode(b);
            return ua != ub ? ua < ub : a < b;
        });
        return;
    }
    std::uint32_t keys[kShort];
    for (std::uint32_t i = begin; i < end; ++i) {
        const HalfEdge h = halfEdges_[i];
        const std::uint32_t key = upperNode(h);
        std::uint32_t j = i - begin;
        for (; j > 0 && keys[j - 1] > key; --j) {
            keys[j] = keys[j - 1];
            halfEdges_[begin + j] = halfEdges_[begin + j - 1];
        }
        keys[j] = key;
        halfEdges_[begin + j] = h;
    }
}

std::span<const HalfEdge> EdgeTable::find(NodeId a, NodeId b) const {
    const NodeId lower = std::min(a, b);
    const auto upper = static_cast<std::uint32_t>(std::max(a, b));
    if (index(lower) + 1 >= offsets_.size()) {
        return {};
    }
    const auto begin = halfEdges_.begin() + offsets_[index(lower)];
    const auto end = halfEdges_.begin() + offsets_[index(lower) + 1];
    const auto first =
        std::lower_bound(begin, end, upper, [this](HalfEdge h, std::uint32_t key) { return upperNode(h) < key; });
    auto last = first;
    while (last != end && upperNode(*last) == upper) {
        ++last;
    }
    return {first, last};
}

} // namespace forefront
