#include "core/engine/mapped/row_grid.hpp"

#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

/// Returns the fractions of length at the places of a side; 0 at all of them if they are equal.
template <class PlaceAt>
std::vector<double> lengthFractions(std::size_t count, const PlaceAt &placeAt) {
    std::vector<double> sums(count + 1, 0.0);
    for (std::size_t k = 1; k <= count; ++k) {
        sums[k] = sums[k - 1] + distance(placeAt(k - 1), placeAt(k));
    }
    const double whole = sums.back();
    for (double &sum : sums) {
        sum = whole > 0.0 ? sum / whole : 0.0;
    }
    return sums;
}

/// Returns the sine-like measure of the smallest angle of a triangle: twice its area over its two longest sides; not
/// positive if it is not counter-clockwise.
double leastSine(Vec2 a, Vec2 b, Vec2 c) {
    std::array<double, 3> lengths = {distance(a, b), distance(b, c), distance(c, a)};
    std::sort(lengths.begin(), lengths.end());
    const double product = lengths[1] * lengths[2];
    return product > 0.0 ? cross(b - a, c - a) / product : 0.0;
}

} // namespace

void RowGrid::interpolate() {
    const std::size_t n = along_, m = across_;
    const auto low = lengthFractions(n, [&](std::size_t i) { return at(i, 0); });
    const auto high = lengthFractions(n, [&](std::size_t i) { return at(i, m); });
    const auto last = lengthFractions(m, [&](std::size_t j) { return at(n, j); });
    auto first = lengthFractions(m, [&](std::size_t j) { return at(0, j); });
    first = first.back() > 0.0 ? first : last; // all places are one corner
    for (std::size_t i = 1; i < n; ++i) {
        for (std::size_t j = 1; j < m; ++j) {
            // Where the lines between equal fractions of opposite sides of the unit square cross.
            const double du = high[i] - low[i], dv = last[j] - first[j];
            const double u = (low[i] + first[j] * du) / (1.0 - du * dv), v = first[j] + u * dv;
            const Vec2 between = (1.0 - u) * at(0, j) + u * at(n, j) + (1.0 - v) * at(i, 0) + v * at(i, m);
            const Vec2 corners =
                (1.0 - u) * ((1.0 - v) * at(0, 0) + v * at(0, m)) + u * ((1.0 - v) * at(n, 0) + v * at(n, m));
            at(i, j) = between - corners;
        }
    }
}

std::optional<RowGrid::Cell> RowGrid::invertedCell(bool triangles) const {
    for (std::size_t i = 0; i < along_; ++i) {
        for (std::size_t j = 0; j < across_; ++j) {
            const auto [a, b, c, d] = corners(i, j);
            const auto left = [](Vec2 p, Vec2 q, Vec2 r) { return orientation(p, q, r) > 0; };
            const bool first = left(a, b, c) && (a == d || left(a, c, d)), second = left(a, b, d) && left(b, c, d);
            if (!(triangles || a == d ? first || second : first && second)) {
                return Cell{i, j};
            }
        }
    }
    return std::nullopt;
}

Vec2 RowGrid::cellCentre(Cell cell) const {
    const auto [a, b, c, d] = corners(cell.first, cell.second);
    return 0.25 * (a + b + c + d);
}

void RowGrid::smoothOnce() {
    for (std::size_t i = 1; i < along_; ++i) {
        for (std::size_t j = 1; j < across_; ++j) {
            const Vec2 xu = 0.5 * (at(i + 1, j) - at(i - 1, j)), xv = 0.5 * (at(i, j + 1) - at(i, j - 1));
            const double alpha = dot(xv, xv), beta = dot(xu, xv), gamma = dot(xu, xu);
            if (!(alpha + gamma > 0.0)) {
                continue;
            }
            const Vec2 mixed = 0.25 * (at(i + 1, j + 1) - at(i + 1, j - 1) - at(i - 1, j + 1) + at(i - 1, j - 1));
            const Vec2 sum = alpha * (at(i + 1, j) + at(i - 1, j)) + gamma * (at(i, j + 1) + at(i, j - 1));
            at(i, j) = (0.5 / (alpha + gamma)) * (sum - 2.0 * beta * mixed);
        }
    }
}

bool RowGrid::smoothUntilValid(bool triangles, const Progress &progress) {
    constexpr int kRounds = 40, kSweeps = 25; // information crosses a cell per sweep
    for (int round = 0; round < kRounds; ++round) {
        for (int sweep = 0; sweep < kSweeps; ++sweep) {
            if (progress.cancelled()) {
                return false;
            }
            smoothOnce();
        }
        if (!invertedCell(triangles)) {
            return true;
        }
    }
    return false;
}

bool RowGrid::firstDiagonal(std::size_t i, std::size_t j) const {
    const auto [a, b, c, d] = corners(i, j);
    const bool valid = orientation(a, b, c) > 0 && orientation(a, c, d) > 0;
    const bool other = orientation(a, b, d) > 0 && orientation(b, c, d) > 0;
    if (valid != other) {
        return valid;
    }
    constexpr double kEqual = 1e-9; // rounding must not choose
    return std::min(leastSine(a, b, c), leastSine(a, c, d)) >=
           std::min(leastSine(a, b, d), leastSine(b, c, d)) - kEqual;
}

} // namespace forefront
