#pragma once

#include "core/spacing/boundary_spacing.hpp"

#include <span>
#include <vector>

namespace forefront {

/// Bounding-box tree over segments (and points as segments without length), for the neighbours of a place whatever the
/// distribution of sizes.
class SegmentTree {
  public:
    explicit SegmentTree(std::vector<PlacedSegment> segments);

    /// Calls visit(position) for every segment whose box overlaps `box`; position is an index into segments().
    template <class Visit>
    void overlapping(const Box2 &box, Visit visit) const {
        visitNode(0, 0, order_.size(), box, visit);
    }
    std::span<const PlacedSegment> segments() const { return segments_; }

  private:
    static constexpr std::size_t kLeaf = 8;

    template <class Visit>
    void visitNode(std::size_t node, std::size_t begin, std::size_t end, const Box2 &box, Visit &visit) const {
        if (begin == end || !boxes_[node].overlaps(box)) {
            return;
        }
        if (end - begin <= kLeaf) {
            for (std::size_t i = begin; i < end; ++i) {
                const PlacedSegment &segment = segments_[order_[i]];
                if (boxOf(segment.a, segment.b).overlaps(box)) {
                    visit(order_[i]);
                }
            }
            return;
        }
        const std::size_t middle = begin + (end - begin) / 2;
        visitNode(2 * node + 1, begin, middle, box, visit);
        visitNode(2 * node + 2, middle, end, box, visit);
    }
    Box2 build(std::size_t node, std::size_t begin, std::size_t end);

    std::vector<PlacedSegment> segments_;
    std::vector<std::uint32_t> order_; ///< halves of it are the children, down to leaves of kLeaf
    std::vector<Box2> boxes_;          ///< of the nodes, heap order
};

} // namespace forefront
