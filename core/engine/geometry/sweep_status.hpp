#pragma once

#include "core/engine/base/ids.hpp"
#include "core/engine/geometry/predicates.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace forefront {

/// The edges that the sweep line crosses, from bottom to top: a linked list for neighbours and a treap over it for
/// searches, both in flat arrays indexed by edge.
class SweepStatus {
  public:
    /// The ends of an edge, lexicographically ordered.
    struct Ends {
        Vec2 low, high;
    };
    /// The neighbours of a point in the status. If the point lies on an edge, only `hit` is set.
    struct Place {
        std::uint32_t below = kNoIndex, above = kNoIndex, hit = kNoIndex;
    };

    explicit SweepStatus(const std::vector<Ends> &ends) : ends_(ends), links_(ends.size()) {}

    std::uint32_t previous(std::uint32_t edge) const { return edge == kNoIndex ? last_ : links_[edge].previous; }
    std::uint32_t next(std::uint32_t edge) const { return edge == kNoIndex ? first_ : links_[edge].next; }

    Place find(Vec2 p) const {
        Place place;
        for (std::uint32_t edge = root_; edge != kNoIndex;) {
            const int side = orientation(ends_[edge].low, ends_[edge].high, p);
            if (side == 0) {
                return {kNoIndex, kNoIndex, edge};
            }
            (side > 0 ? place.below : place.above) = edge;
            edge = side > 0 ? links_[edge].right : links_[edge].left;
        }
        return place;
    }

    /// Inserts `edge` directly above `below` (kNoIndex: at the bottom).
    void insertAbove(std::uint32_t below, std::uint32_t edge) {
        const std::uint32_t above = next(below);
        Link &link = links_[edge];
        link = {kNoIndex, kNoIndex, kNoIndex, below, above, nextPriority()};
        (below == kNoIndex ? first_ : links_[below].next) = edge;
        (above == kNoIndex ? last_ : links_[above].previous) = edge;
        if (root_ == kNoIndex) {
            root_ = edge;
            return;
        }
        if (below != kNoIndex && links_[below].right == kNoIndex) {
            links_[below].right = edge;
            link.parent = below;
        } else { // the one above is leftmost in the right subtree of the one below
            links_[above].left = edge;
            link.parent = above;
        }
        while (link.parent != kNoIndex && links_[link.parent].priority < link.priority) {
            rotateUp(edge);
        }
    }

    void erase(std::uint32_t edge) {
        Link &link = links_[edge];
        while (link.left != kNoIndex && link.right != kNoIndex) {
            rotateUp(links_[link.left].priority > links_[link.right].priority ? link.left : link.right);
        }
        const std::uint32_t child = link.left != kNoIndex ? link.left : link.right;
        if (child != kNoIndex) {
            links_[child].parent = link.parent;
        }
        childSlot(link.parent, edge) = child;
        (link.previous == kNoIndex ? first_ : links_[link.previous].next) = link.next;
        (link.next == kNoIndex ? last_ : links_[link.next].previous) = link.previous;
    }

    /// Replaces `old` by `fresh`.
    void replace(std::uint32_t old, std::uint32_t fresh) {
        const Link &link = links_[fresh] = links_[old];
        if (link.left != kNoIndex) {
            links_[link.left].parent = fresh;
        }
        if (link.right != kNoIndex) {
            links_[link.right].parent = fresh;
        }
        childSlot(link.parent, old) = fresh;
        (link.previous == kNoIndex ? first_ : links_[link.previous].next) = fresh;
        (link.next == kNoIndex ? last_ : links_[link.next].previous) = fresh;
    }

  private:
    struct Link {
        std::uint32_t left = kNoIndex, right = kNoIndex, parent = kNoIndex, previous = kNoIndex, next = kNoIndex;
        std::uint32_t priority = 0;
    };

    /// Returns the link of the parent (or the root) that refers to `child`.
    std::uint32_t &childSlot(std::uint32_t parent, std::uint32_t child) {
        if (parent == kNoIndex) {
            return root_;
        }
        return links_[parent].left == child ? links_[parent].left : links_[parent].right;
    }

    void rotateUp(std::uint32_t edge) {
        Link &link = links_[edge];
        const std::uint32_t parent = link.parent;
        Link &above = links_[parent];
        const bool fromLeft = above.left == edge;
        std::uint32_t &moved = fromLeft ? link.right : link.left;
        (fromLeft ? above.left : above.right) = moved;
        if (moved != kNoIndex) {
            links_[moved].parent = parent;
        }
        moved = parent;
        childSlot(above.parent, parent) = edge;
        link.parent = above.parent;
        above.parent = edge;
    }

    /// Returns the next priority of a fixed sequence (G. Marsaglia's xorshift), so that the tree is always the same.
    std::uint32_t nextPriority() {
        random_ ^= random_ << 13;
        random_ ^= random_ >> 17;
        random_ ^= random_ << 5;
        return random_;
    }

    const std::vector<Ends> &ends_;
    std::vector<Link> links_;
    std::uint32_t root_ = kNoIndex, first_ = kNoIndex, last_ = kNoIndex;
    std::uint32_t random_ = 2463534242U;
};

} // namespace forefront
