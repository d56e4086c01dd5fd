#include "core/engine/mapped/row_untangle.hpp"

#include "core/engine/geometry/compass.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace forefront {

namespace {

constexpr double kSought = 0.2; ///< least sine of a corner, of a cell that is left as it is

double sineAt(Vec2 corner, Vec2 next, Vec2 before) {
    const double lengths = distance(corner, next) * distance(corner, before);
    return lengths > 0.0 ? cross(next - corner, before - corner) / lengths : -1.0;
}

/// Returns the least sine of the corners of a triangle; not positive if it is not counter-clockwise.
double triangleSine(Vec2 a, Vec2 b, Vec2 c) {
    return std::min({sineAt(a, b, c), sineAt(b, c, a), sineAt(c, a, b)});
}

class RowUntangling {
  public:
    RowUntangling(RowGrid &grid, bool triangles) : grid_(grid), triangles_(triangles) {}

    bool run(const Progress &progress) {
        constexpr int kRounds = 200; // a move reaches the next place per round
        for (int round = 0; round < kRounds; ++round) {
            if (progress.cancelled()) {
                return false;
            }
            if (!improve()) {
                break;
            }
        }
        return !grid_.invertedCell(triangles_);
    }

  private:
    /// Returns the least sine of the corners of the cell with a corner (i, j) and the next ones; of the triangles, if
    /// it is divided into them.
    double cellSine(std::size_t i, std::size_t j) const {
        const Vec2 a = grid_.at(i, j), b = grid_.at(i + 1, j), c = grid_.at(i + 1, j + 1), d = grid_.at(i, j + 1);
        if (a == d) {
            return triangleSine(a, b, c);
        }
        if (triangles_) {
            return std::max(std::min(triangleSine(a, b, c), triangleSine(a, c, d)),
                            std::min(triangleSine(a, b, d), triangleSine(b, c, d)));
        }
        return std::min({sineAt(a, b, d), sineAt(b, c, a), sineAt(c, d, b), sineAt(d, a, c)});
    }
    double sineAround(std::size_t i, std::size_t j) const {
        return std::min({cellSine(i - 1, j - 1), cellSine(i, j - 1), cellSine(i - 1, j), cellSine(i, j)});
    }

    /// Moves each inner place beside a poor cell. Returns true if one moved.
    bool improve() {
        bool moved = false;
        for (std::size_t i = 1; i < grid_.along(); ++i) {
            for (std::size_t j = 1; j < grid_.across(); ++j) {
                moved = (sineAround(i, j) < kSought && search(i, j)) || moved;
            }
        }
        return moved;
    }

    double meanReach(std::size_t i, std::size_t j) const {
        const Vec2 p = grid_.at(i, j);
        return 0.25 * (distance(p, grid_.at(i - 1, j)) + distance(p, grid_.at(i + 1, j)) +
                       distance(p, grid_.at(i, j - 1)) + distance(p, grid_.at(i, j + 1)));
    }

    /// Searches a better place by a pattern. Returns true if the place moved.
    bool search(std::size_t i, std::size_t j) {
        constexpr int kSteps = 12;
        constexpr double kGain = 1e-6;
        double best = sineAround(i, j), step = 0.25 * meanReach(i, j);
        bool moved = false;
        for (int t = 0; t < kSteps && best < kSought; ++t) {
            const Vec2 start = grid_.at(i, j);
            Vec2 place = start;
            for (const Vec2 direction : kCompass) {
                grid_.at(i, j) = start + step * direction;
                if (const double sine = sineAround(i, j); sine > best + kGain) {
                    best = sine;
                    place = grid_.at(i, j);
                }
            }
            grid_.at(i, j) = place;
            moved = moved || !(place == start);
            step *= place == start ? 0.5 : 1.0;
        }
        return moved;
    }

    RowGrid &grid_;
    bool triangles_;
};

/// Returns the place of a grid that is nearest to one of a grid with other numbers of rows.
std::size_t scaledIndex(std::size_t k, std::size_t from, std::size_t to) {
    return (2 * k * to + from) / (2 * from);
}

/// Returns a grid with the outline of another one and half as many rows; its inner places are not set.
RowGrid coarseOutline(const RowGrid &grid) {
    RowGrid coarse((grid.along() + 1) / 2, (grid.across() + 1) / 2);
    const std::size_t n = coarse.along(), m = coarse.across();
    for (std::size_t i = 0; i <= n; ++i) {
        const std::size_t at = scaledIndex(i, n, grid.along());
        coarse.at(i, 0) = grid.at(at, 0);
        coarse.at(i, m) = grid.at(at, grid.across());
    }
    for (std::size_t j = 0; j <= m; ++j) {
        const std::size_t at = scaledIndex(j, m, grid.across());
        coarse.at(0, j) = grid.at(0, at);
        coarse.at(n, j) = grid.at(grid.along(), at);
    }
    return coarse;
}

/// Sets the inner places of a grid between those of a coarse one.
void setBetween(const RowGrid &coarse, RowGrid &grid) {
    for (std::size_t i = 1; i < grid.along(); ++i) {
        const std::size_t ki = i * coarse.along() / grid.along();
        const double u =
            static_cast<double>(i * coarse.along() - ki * grid.along()) / static_cast<double>(grid.along());
        for (std::size_t j = 1; j < grid.across(); ++j) {
            const std::size_t kj = j * coarse.across() / grid.across();
            const double v =
                static_cast<double>(j * coarse.across() - kj * grid.across()) / static_cast<double>(grid.across());
            grid.at(i, j) = (1.0 - v) * ((1.0 - u) * coarse.at(ki, kj) + u * coarse.at(ki + 1, kj)) +
                            v * ((1.0 - u) * coarse.at(ki, kj + 1) + u * coarse.at(ki + 1, kj + 1));
        }
    }
}

} // namespace

bool untangleRows(RowGrid &grid, bool triangles, const Progress &progress) {
    constexpr std::size_t kFewRows = 8;
    if (std::min(grid.along(), grid.across()) > kFewRows) {
        RowGrid coarse = coarseOutline(grid);
        coarse.interpolate();
        if (!coarse.invertedCell(triangles) || untangleRows(coarse, triangles, progress)) {
            setBetween(coarse, grid);
        }
    }
    return RowUntangling(grid, triangles).run(progress);
}

} // namespace forefront
