#pragma once

#include "core/base/ids.hpp"
#include "core/base/vec2.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A static tree over boxes, for finding the items near a place. Works for any sizes and distribution.
///
/// Items lie in Morton order of their centres, with `kFan` children per box. Building sorts once, O(n log n). A query
/// visits items in an order that depends on the boxes alone. Boxes may be degenerate, or as large as doubles go; an
/// item whose box holds a NaN is never found.
class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(std::span<const Box2> boxes);

    std::size_t size() const { return items_.size(); }

    /// Calls visit(item) for every item whose box meets `box`.
    template <class Visit>
    void query(const Box2 &box, Visit &&visit) const {
        search([&](const Box2 &other) { return other.overlaps(box); },
               [&](std::uint32_t item) {
                   visit(item);
                   return true;
               });
    }

    /// Calls visit(item) for every item whose box passes meets(box), until visit returns false. meets() must also be
    /// true for every box that contains a box for which it is true. Returns false if a visit stopped the search.
    template <class Meets, class Visit>
    bool search(const Meets &meets, const Visit &visit) const {
        return levels_.empty() || descend(levels_.size() - 1, 0, levels_.back().size(), meets, visit);
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
    static constexpr std::size_t kFan = 8;

    std::size_t lastChild(std::size_t level, std::size_t k) const {
        return std::min((k + 1) * kFan, levels_[level - 1].size());
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

    std::vector<std::uint32_t> items_;      ///< in Morton order
    std::vector<std::vector<Box2>> levels_; ///< levels_[0][k] is the box of items_[k]
};

} // namespace forefront
