#include "core/spacing/segment_tree.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace forefront {

SegmentTree::SegmentTree(std::vector<PlacedSegment> segments) : segments_(std::move(segments)) {
    order_.resize(segments_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    boxes_.resize(2 * std::bit_ceil(std::max<std::size_t>(1, order_.size())));
    build(0, 0, order_.size());
}

Box2 SegmentTree::build(std::size_t node, std::size_t begin, std::size_t end) {
    Box2 box;
    if (end - begin <= kLeaf) {
        for (std::size_t i = begin; i < end; ++i) {
            box.add(boxOf(segments_[order_[i]].a, segments_[order_[i]].b));
        }
    } else {
        Box2 centres;
        for (std::size_t i = begin; i < end; ++i) {
            centres.add(midpoint(segments_[order_[i]].a, segments_[order_[i]].b));
        }
        const bool wide = centres.size().x >= centres.size().y;
        const auto key = [&](std::uint32_t i) {
            const Vec2 centre = midpoint(segments_[i].a, segments_[i].b);
            return wide ? centre.x : centre.y;
        };
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(begin), at(middle), at(end),
                         [&](std::uint32_t p, std::uint32_t q) { return key(p) != key(q) ? key(p) < key(q) : p < q; });
        box.add(build(2 * node + 1, begin, middle));
        box.add(build(2 * node + 2, middle, end));
    }
    boxes_[node] = box;
    return box;
}

} // namespace forefront
