#pragma once

#include "core/engine/base/ids.hpp"
#include "core/engine/base/vec2.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// Finds nodes by their places within a tolerance: places in cells of the size of the tolerance, sorted.
class ImageNodes {
  public:
    /// `nodes`: indices into `places`, which must outlive it. `tolerance` > 0, domain units.
    ImageNodes(std::span<const Vec2> places, std::span<const std::uint32_t> nodes, double tolerance)
        : places_(places), tolerance_(tolerance), origin_(nodes.empty() ? Vec2{} : places[nodes.front()]) {
        for (const std::uint32_t node : nodes) {
            const auto [i, j] = cellOf(places[node]);
            cells_.push_back({i, j, node});
        }
        std::sort(cells_.begin(), cells_.end());
    }

    /// Returns the node nearest to a place within the tolerance, of equally near ones the first; kNoIndex: none.
    std::uint32_t find(Vec2 place) const {
        std::uint32_t best = kNoIndex;
        double nearest = tolerance_;
        const auto [i, j] = cellOf(place);
        for (std::int64_t column = i - 1; column <= i + 1; ++column) {
            const std::array<std::int64_t, 3> from = {column, j - 1, 0};
            for (auto cell = std::lower_bound(cells_.begin(), cells_.end(), from);
                 cell != cells_.end() && (*cell)[0] == column && (*cell)[1] <= j + 1; ++cell) {
                const auto node = static_cast<std::uint32_t>((*cell)[2]);
                if (const double away = distance(places_[node], place);
                    away < nearest || (away == nearest && node < best)) {
                    nearest = away;
                    best = node;
                }
            }
        }
        return best;
    }

  private:
    std::array<std::int64_t, 2> cellOf(Vec2 p) const {
        constexpr double kReach = 4e18; // of 64 bits; places beyond it are in no cell that counts
        const auto cell = [&](double offset) {
            return static_cast<std::int64_t>(std::clamp(std::floor(offset / tolerance_), -kReach, kReach));
        };
        return {cell(p.x - origin_.x), cell(p.y - origin_.y)};
    }

    std::span<const Vec2> places_;
    double tolerance_;
    Vec2 origin_;
    std::vector<std::array<std::int64_t, 3>> cells_; ///< column, row, node
};

} // namespace forefront
