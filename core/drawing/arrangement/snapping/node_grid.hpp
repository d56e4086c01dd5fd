#pragma once

#include "core/engine/base/hash.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/vec2.hpp"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace forefront {

/// Finds nodes near a place: a grid whose cells are kept in a hash table, since only few of them hold nodes.
class NodeGrid {
  public:
    /// `reach`: how far nodes are searched. `limit`: expected number of nodes; with more, searches take longer.
    NodeGrid(double reach, std::size_t limit)
        : reach_(reach), cell_(kCell * reach), first_(std::bit_ceil(limit + 1), kNoIndex) {}

    /// Adds a node unless it is known.
    void add(std::uint32_t node, Vec2 place) {
        if (node >= next_.size()) {
            next_.resize(std::size_t{node} + 1, kUnknown);
        }
        if (next_[node] == kUnknown) {
            std::uint32_t &first = first_[slot(std::floor(place.x / cell_), std::floor(place.y / cell_))];
            next_[node] = first;
            first = node;
        }
    }

    /// Calls visit(node) for all nodes within reach of a place, and for others.
    template <class Visit>
    void visitNear(Vec2 place, const Visit &visit) const {
        const auto step = [&](double x) { return std::floor(x / cell_); };
        const double left = step(place.x - reach_), right = step(place.x + reach_);
        const double bottom = step(place.y - reach_), top = step(place.y + reach_);
        visitCell(left, bottom, visit);
        if (right != left) {
            visitCell(right, bottom, visit);
        }
        if (top != bottom) {
            visitCell(left, top, visit);
        }
        if (right != left && top != bottom) {
            visitCell(right, top, visit);
        }
    }

  private:
    static constexpr double kCell = 8.0; ///< in reaches: most searches need one cell only
    static constexpr std::uint32_t kUnknown = kNoIndex - 1;

    std::size_t slot(double column, double row) const {
        Hash64 hash;
        hash.add(column);
        hash.add(row);
        return static_cast<std::size_t>(hash.value()) & (first_.size() - 1);
    }

    template <class Visit>
    void visitCell(double column, double row, const Visit &visit) const {
        for (std::uint32_t node = first_[slot(column, row)]; node != kNoIndex; node = next_[node]) {
            visit(node);
        }
    }

    double reach_;
    double cell_;
    std::vector<std::uint32_t> first_; ///< per slot: a node in it
    std::vector<std::uint32_t> next_;  ///< per node: the next one in its slot
};

} // namespace forefront
