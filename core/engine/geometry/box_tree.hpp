#pragma once

#include "core/engine/base/ids.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/geometry/box_block.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A static tree over boxes, for finding the items near a place. Works for any sizes and distribution.
///
/// Items lie in the order of their centres along a Hilbert curve, with `kFan` children per box. Building sorts once,
/// O(n log n). A query visits items in an order that depends on the boxes alone. Boxes may be degenerate, or as large
/// as doubles go; an item whose box holds a NaN is never found.
class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(std::span<const Box2> boxes);

    std::size_t size() const { return items_.size(); }
    /// Returns the items in the order in which queries visit them.
    const std::vector<std::uint32_t> &items() const { return items_; }

    /// Calls visit(item) for every item whose box meets `box`.
    template <class Visit>
    void query(const Box2 &box, Visit &&visit) const {
        search(box, [&](std::uint32_t item) {
            visit(item);
            return true;
        });
    }

    /// Calls visit(item) for every item whose box meets `box`, until visit returns false. A visit may shrink the box.
    /// Returns false if a visit stopped the search.
    template <class Visit>
    bool search(const Box2 &box, const Visit &visit) const {
        return levels_.empty() || descend(topLevel(), 0, scale_(box), box, visit);
    }

    /// Calls visit(item) for every item whose box passes meets(box), until visit returns false. meets() must also be
    /// true for every box that contains a box for which it is true. Returns false if a visit stopped the search.
    template <class Meets, class Visit>
    bool search(const Meets &meets, const Visit &visit) const {
        return levels_.empty() || descend(levels_.size() - 1, 0, levels_.back().size(), meets, visit);
    }

    /// Calls visit(mine, theirs) for every item of this tree and every item of another whose boxes are within `reach`
    /// of each other in both directions, until visit returns false. Descends both trees together, which is several
    /// times as fast as one query per item. Returns false if a visit stopped the search.
    template <class Visit>
    bool join(const BoxTree &other, double reach, const Visit &visit) const {
        for (std::size_t k = 0; k < rootCount(); ++k) {
            for (std::size_t m = 0; m < other.rootCount(); ++m) {
                const Node mine{topLevel(), k}, theirs{other.topLevel(), m};
                if (boxOf(mine).grown(reach).overlaps(other.boxOf(theirs)) &&
                    !joinNodes(mine, other, theirs, reach, visit)) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Does the same for pairs of different items of this tree; each pair is found once.
    template <class Visit>
    bool joinSelf(double reach, const Visit &visit) const {
        return levels_.empty() || joinAmong(topLevel(), 0, rootCount(), reach, visit);
    }

    /// Returns the item nearest to p by distance(item), which must be at least the distance to the item's box. Items
    /// farther than `limit` do not count; of items at the same distance the smaller one wins; kNoIndex if there is
    /// none. On return `limit` is the distance found.
    template <class Distance>
    std::uint32_t nearest(Vec2 p, double &limit, Distance &&distance) const {
        std::uint32_t best = kNoIndex;
        if (!levels_.empty()) {
            approach(levels_.size() - 1, 0, levels_.back().size(), p, limit, best, distance);
        }
        return best;
    }

  private:
    static constexpr std::size_t kFan = BoxBlock::kWidth;

    std::size_t lastChild(std::size_t level, std::size_t k) const {
        return std::min((k + 1) * kFan, levels_[level - 1].size());
    }

    /// Searches the children from `first` on. `rough` is the rounded box from when the search began.
    template <class Visit>
    bool descend(std::size_t level, std::size_t first, const StepBox &rough, const Box2 &box,
                 const Visit &visit) const {
        for (unsigned near = blocks_[level][first / kFan].overlapping(rough); near != 0; near &= near - 1) {
            const std::size_t k = first + static_cast<std::size_t>(std::countr_zero(near));
            if (levels_[level][k].overlaps(box) &&
                !(level == 0 ? visit(items_[k]) : descend(level - 1, k * kFan, rough, box, visit))) {
                return false;
            }
        }
        return true;
    }

    template <class Meets, class Visit>
    bool descend(std::size_t level, std::size_t first, std::size_t last, const Meets &meets, const Visit &visit) const {
        for (std::size_t k = first; k < last; ++k) {
            if (!meets(levels_[level][k])) {
                continue;
            }
            if (level == 0 ? !visit(items_[k]) : !descend(level - 1, k * kFan, lastChild(level, k), meets, visit)) {
                return false;
            }
        }
        return true;
    }

    /// A box of the tree.
    struct Node {
        std::size_t level = 0, index = 0;
    };

    std::size_t topLevel() const { return levels_.size() - 1; }
    std::size_t rootCount() const { return levels_.empty() ? 0 : levels_.back().size(); }
    const Box2 &boxOf(Node node) const { return levels_[node.level][node.index]; }

    /// Joins the items below a node with those below a node of another tree, which is within reach.
    template <class Visit>
    bool joinNodes(Node mine, const BoxTree &other, Node theirs, double reach, const Visit &visit) const {
        if (mine.level == 0 && theirs.level == 0) {
            return visit(items_[mine.index], other.items_[theirs.index]);
        }
        const bool splitMine = mine.level >= theirs.level;
        const Node whole = splitMine ? mine : theirs;
        const BoxTree &tree = splitMine ? *this : other;
        const Box2 around = (splitMine ? other.boxOf(theirs) : boxOf(mine)).grown(reach);
        const std::size_t last = tree.lastChild(whole.level, whole.index);
        for (std::size_t k = whole.index * kFan; k < last; ++k) {
            const Node part{whole.level - 1, k};
            if (around.overlaps(tree.boxOf(part)) &&
                !joinNodes(splitMine ? part : mine, other, splitMine ? theirs : part, reach, visit)) {
                return false;
            }
        }
        return true;
    }

    /// Joins the items below the nodes of a level from `first` up to `last` with each other.
    template <class Visit>
    bool joinAmong(std::size_t level, std::size_t first, std::size_t last, double reach, const Visit &visit) const {
        for (std::size_t k = first; k < last; ++k) {
            if (level > 0 && !joinAmong(level - 1, k * kFan, lastChild(level, k), reach, visit)) {
                return false;
            }
            const Box2 around = boxOf({level, k}).grown(reach);
            for (std::size_t m = k + 1; m < last; ++m) {
                if (around.overlaps(boxOf({level, m})) && !joinNodes({level, k}, *this, {level, m}, reach, visit)) {
                    return false;
                }
            }
        }
        return true;
    }

    template <class Distance>
    void approach(std::size_t level, std::size_t first, std::size_t last, Vec2 p, double &limit, std::uint32_t &best,
                  Distance &distance) const {
        for (std::size_t k = first; k < last; ++k) {
            // The limit shrinks as better items turn up, so each box is tested only when its turn comes.
            if (!(boxDistance(levels_[level][k], p) <= limit)) {
                continue;
            }
            if (level == 0) {
                const double d = distance(items_[k]);
                if (d < limit || (d == limit && items_[k] < best)) {
                    limit = d;
                    best = items_[k];
                }
            } else {
                approach(level - 1, k * kFan, lastChild(level, k), p, limit, best, distance);
            }
        }
    }

    static double boxDistance(const Box2 &box, Vec2 p) {
        const double dx = std::max({box.min.x - p.x, 0.0, p.x - box.max.x});
        const double dy = std::max({box.min.y - p.y, 0.0, p.y - box.max.y});
        return std::sqrt(dx * dx + dy * dy);
    }

    std::vector<std::uint32_t> items_;          ///< along the curve
    std::vector<std::vector<Box2>> levels_;     ///< levels_[0][k] is the box of items_[k]
    std::vector<std::vector<BoxBlock>> blocks_; ///< the same, rounded, kFan at a time
    StepScale scale_;                           ///< of the blocks
};

} // namespace forefront
