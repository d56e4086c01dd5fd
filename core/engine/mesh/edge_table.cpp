#include "core/engine/mesh/edge_table.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// Counts the sides of the elements of a block at their lower nodes.
template <std::size_t Corners>
void countSides(const MeshView::Block &block, std::vector<std::uint32_t> &counts) {
    const std::size_t step = block.traits().nodes;
    for (const NodeId *n = block.connectivity.data(), *end = n + block.connectivity.size(); n != end; n += step) {
        for (std::size_t k = 0; k < Corners; ++k) {
            ++counts[index(std::min(n[k], n[(k + 1) % Corners]))];
        }
    }
}

} // namespace

EdgeTable::EdgeTable(const MeshView &mesh)
    : sides_(mesh), offsets_(mesh.nodes.size() + 1, 0), ordered_(sides_.count()) {
    for (const MeshView::Block &block : mesh.blocks()) {
        block.traits().corners == 3 ? countSides<3>(block, offsets_) : countSides<4>(block, offsets_);
    }
    std::uint32_t sum = 0;
    for (std::uint32_t &offset : offsets_) {
        sum += offset;
        offset = sum;
    }
    // Filled from the back, so that each row is ascending and its offset ends at its first entry.
    for (HalfEdge h = static_cast<HalfEdge>(ordered_.size()); h-- > 0;) {
        ordered_[--offsets_[lowerNode(h)]] = h;
    }
    for (std::size_t n = 0; n + 1 < offsets_.size(); ++n) {
        sortRow(offsets_[n], offsets_[n + 1]);
    }
}

void EdgeTable::sortRow(std::uint32_t begin, std::uint32_t end) {
    constexpr std::uint32_t kShort = 24;
    if (end - begin > kShort) {
        std::sort(ordered_.begin() + begin, ordered_.begin() + end, [this](HalfEdge a, HalfEdge b) {
            const std::uint32_t ua = upperNode(a), ub = upperNode(b);
            return ua != ub ? ua < ub : a < b;
        });
        return;
    }
    std::uint32_t keys[kShort];
    for (std::uint32_t i = begin; i < end; ++i) {
        const HalfEdge h = ordered_[i];
        const std::uint32_t key = upperNode(h);
        std::uint32_t j = i - begin;
        for (; j > 0 && keys[j - 1] > key; --j) {
            keys[j] = keys[j - 1];
            ordered_[begin + j] = ordered_[begin + j - 1];
        }
        keys[j] = key;
        ordered_[begin + j] = h;
    }
}

std::span<const HalfEdge> EdgeTable::find(NodeId a, NodeId b) const {
    const NodeId lower = std::min(a, b);
    const auto upper = static_cast<std::uint32_t>(std::max(a, b));
    if (index(lower) + 1 >= offsets_.size()) {
        return {};
    }
    const auto begin = ordered_.begin() + offsets_[index(lower)];
    const auto end = ordered_.begin() + offsets_[index(lower) + 1];
    const auto first =
        std::lower_bound(begin, end, upper, [this](HalfEdge h, std::uint32_t key) { return upperNode(h) < key; });
    auto last = first;
    while (last != end && upperNode(*last) == upper) {
        ++last;
    }
    return {first, last};
}

} // namespace forefront
