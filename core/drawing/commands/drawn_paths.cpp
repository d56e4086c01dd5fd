#include "core/drawing/commands/drawn_paths.hpp"

#include "core/engine/geometry/polygon.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace forefront {
namespace {

/// Returns the velocity at the middle of three points on the parabola through them; g and h are the time steps.
Vec2 velocity(Vec2 before, Vec2 at, Vec2 after, double g, double h) {
    return (1.0 / (g + h)) * ((h / g) * (at - before) + (g / h) * (after - at));
}

} // namespace

std::vector<Curve> splineThrough(std::span<const Vec2> points, bool closed) {
    if (points.empty()) {
        return {};
    }
    const std::size_t n = points.size(), count = closed ? n : n - 1;
    if (n < 3) {
        return {count, Curve()};
    }
    const auto at = [&](std::size_t k) { return points[k % n]; };
    const auto time = [&](std::size_t k) { return std::sqrt(distance(at(k), at(k + 1))); };
    std::vector<Vec2> speeds(n);
    for (std::size_t k = closed ? 0 : 1; k < (closed ? n : n - 1); ++k) {
        speeds[k] = velocity(at(k + n - 1), at(k), at(k + 1), time(k + n - 1), time(k));
    }
    if (!closed) { // the end tangents are those of the outer parabolas
        speeds[0] = (2.0 / time(0)) * (at(1) - at(0)) - speeds[1];
        speeds[n - 1] = (2.0 / time(n - 2)) * (at(n - 1) - at(n - 2)) - speeds[n - 2];
    }
    std::vector<Curve> curves;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec2 a = at(k), b = at(k + 1);
        const double third = time(k) / 3.0;
        curves.push_back(Curve::cubic(a, a + third * speeds[k], b - third * speeds[(k + 1) % n], b));
    }
    return curves;
}

std::vector<Vec2> simplified(std::span<const Vec2> points, double tolerance) {
    if (points.size() < 3) {
        return {points.begin(), points.end()};
    }
    std::vector<bool> kept(points.size(), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        std::size_t farthest = first;
        double most = tolerance;
        for (std::size_t k = first + 1; k < last; ++k) {
            const double d = distanceToSegment(points[first], points[last], points[k]);
            if (d > most) {
                most = d;
                farthest = k;
            }
        }
        if (farthest != first) {
            kept[farthest] = true;
            open.emplace_back(first, farthest);
            open.emplace_back(farthest, last);
        }
    }
    std::vector<Vec2> result;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (kept[k]) {
            result.push_back(points[k]);
        }
    }
    return result;
}

} // namespace forefront
