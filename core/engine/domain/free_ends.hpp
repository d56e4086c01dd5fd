#pragma once

#include "core/engine/geometry/box_tree.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace forefront {

/// Finds the free end of a line that is nearest to another free end.
class FreeEnds {
  public:
    explicit FreeEnds(std::vector<Vec2> ends) : ends_(std::move(ends)) {
        std::vector<Box2> boxes;
        boxes.reserve(ends_.size());
        for (const Vec2 end : ends_) {
            boxes.push_back(boxOf(end, end));
        }
        tree_ = BoxTree(boxes);
    }
    /// Returns the distance from end k to the nearest other one; infinity if there is none.
    double gap(std::size_t k) const {
        double limit = std::numeric_limits<double>::infinity();
        tree_.nearest(ends_[k], limit, [&](std::uint32_t other) {
            return other == k ? std::numeric_limits<double>::infinity() : distance(ends_[k], ends_[other]);
        });
        return limit;
    }

  private:
    std::vector<Vec2> ends_;
    BoxTree tree_;
};

} // namespace forefront
