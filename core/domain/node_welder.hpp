#pragma once

#include "core/base/vec2.hpp"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <utility>
#include <vector>

namespace forefront {

/// Creates nodes at crossings, and reuses an existing node within rounding error. Otherwise three lines through one
/// point would leave a triangle the size of the rounding error.
class NodeWelder {
  public:
    /// New nodes are appended to `nodes`, which must outlive this object. `bounds` is the box of all nodes.
    NodeWelder(std::vector<Vec2> &nodes, const Box2 &bounds) : nodes_(nodes), bounds_(bounds) {
        const double magnitude = std::max(
            {std::fabs(bounds.min.x), std::fabs(bounds.max.x), std::fabs(bounds.min.y), std::fabs(bounds.max.y)});
        tolerance_ = std::max({1e-12 * bounds.diagonal(), 4e-15 * magnitude, std::numeric_limits<double>::min()});
    }

    /// Returns the distance within which nodes count as one: 1e-12 of the extent, or a few units in the last place.
    double tolerance() const { return tolerance_; }

    /// Records that the node of greater index moves onto the other one. Returns false if they are too far apart.
    bool weld(std::uint32_t m, std::uint32_t n) {
        if (distance(nodes_[m], nodes_[n]) > tolerance_) {
            return false;
        }
        if (m != n) {
            welds_.emplace_back(std::max(m, n), std::min(m, n));
        }
        return true;
    }
    /// Returns the recorded pairs: a node that moves, at most once, and the one it moves onto.
    const std::vector<std::pair<std::uint32_t, std::uint32_t>> &welds() {
        std::sort(welds_.begin(), welds_.end());
        welds_.erase(std::unique(welds_.begin(), welds_.end(), [](auto s, auto t) { return s.first == t.first; }),
                     welds_.end());
        return welds_;
    }
    /// Moves the recorded nodes and clears the record.
    void move() {
        for (const auto &[node, into] : welds()) {
            nodes_[node] = nodes_[into];
        }
        welds_.clear();
    }

    /// Returns one of `ends` or an earlier node within the tolerance of `at`, else a new node there.
    std::uint32_t nodeAt(Vec2 at, std::initializer_list<std::uint32_t> ends) {
        std::uint32_t best = 0;
        double nearest = std::numeric_limits<double>::infinity();
        for (const std::uint32_t node : ends) {
            if (const double gap = distance(nodes_[node], at); gap < nearest) {
                nearest = gap;
                best = node;
            }
        }
        if (nearest <= tolerance_) {
            return best;
        }
        const auto [column, row] = cellOf(at);
        for (const double i : {column - 1.0, column, column + 1.0}) {
            for (const double j : {row - 1.0, row, row + 1.0}) {
                if (const auto found = made_.find({i, j}); found != made_.end()) {
                    for (const std::uint32_t node : found->second) {
                        if (distance(nodes_[node], at) <= tolerance_) {
                            return node;
                        }
                    }
                }
            }
        }
        const auto node = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back(at);
        made_[{column, row}].push_back(node);
        return node;
    }

  private:
    std::pair<double, double> cellOf(Vec2 at) const {
        return {std::floor((at.x - bounds_.min.x) / tolerance_), std::floor((at.y - bounds_.min.y) / tolerance_)};
    }

    std::vector<Vec2> &nodes_;
    Box2 bounds_;
    double tolerance_ = 0.0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> welds_;
    std::map<std::pair<double, double>, std::vector<std::uint32_t>> made_;
};

} // namespace forefront
