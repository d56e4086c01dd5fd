#pragma once

#include "core/base/ids.hpp"
#include "core/base/vec2.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A static tree over boxes for picking: items lie in Morton order of their centres, sixteen to a leaf, sixteen
/// children to a box above. Building sorts once, O(n log n); a query sees only the boxes it meets.
class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(std::span<const Box2> boxes);

    std::size_t size() const { return items_.size(); }

    /// Calls visit(item) for every item whose box meets `box`, in an order that depends on the boxes alone.
    template <class Visit>
    void query(const Box2 &box, Visit &&visit) const {
        if (!levels_.empty()) {
            descend(levels_.size() - 1, 0, levels_.back().size(), box, visit);
        }
    }

    /// The item nearest to p by distance(item) (>= distance to its box), not farther than `limit`; ties go to the
    /// smaller item. kNoIndex if there is none. On return `limit` is the distance found.
    template <class Distance>
    std::uint32_t nearest(Vec2 p, double &limit, Distance &&distance) const {
        std::uint32_t best = kNoIndex;
        if (!levels_.empty()) {
            approach(levels_.size() - 1, 0, levels_.back().size(), p, limit, best, distance);
        }
        return best;
    }

  private:
    static constexpr std::size_t kFan = 16;

    template <class Visit>
    void descend(std::size_t level, std::size_t first, std::size_t last, const Box2 &box, Visit &visit) const {
        for (std::size_t k = first; k < last; ++k) {
            if (!levels_[level][k].overlaps(box)) {
                continue;
            }
            if (level == 0) {
                visit(items_[k]);
            } else {
                descend(level - 1, k * kFan, std::min((k + 1) * kFan, levels_[level - 1].size()), box, visit);
            }
        }
    }

    template <class Distance>
    void approach(std::size_t level, std::size_t first, std::size_t last, Vec2 p, double &limit, std::uint32_t &best,
                  Distance &distance) const {
        for (std::size_t k = first; k < last; ++k) {
            // The limit shrinks as better items turn up, so each box is judged when its turn comes.
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
                approach(level - 1, k * kFan, std::min((k + 1) * kFan, levels_[level - 1].size()), p, limit, best,
                         distance);
            }
        }
    }

    static double boxDistance(const Box2 &box, Vec2 p) {
        const double dx = std::max({box.min.x - p.x, 0.0, p.x - box.max.x});
        const double dy = std::max({box.min.y - p.y, 0.0, p.y - box.max.y});
        return std::sqrt(dx * dx + dy * dy);
    }

    std::vector<std::uint32_t> items_;      ///< in Morton order
    std::vector<std::vector<Box2>> levels_; ///< levels_[0][k] is the box of items_[k]
};

} // namespace forefront
