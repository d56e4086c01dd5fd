#include "core/engine/geometry/stroke_fit.hpp"

#include "core/engine/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

namespace forefront {
namespace {

/// Length of the stroke over which a corner or a tangent is measured, in tolerances.
constexpr double kWindow = 8.0;
/// Turn that makes a corner if half of it, too, happens within half of the window. A bend of a larger radius than two
/// thirds of the window stays smooth.
constexpr double kCornerTurn = 50.0 * std::numbers::pi / 180.0;
constexpr double kNearTurn = 40.0 * std::numbers::pi / 180.0;
/// Passes that move the parameters of points to the nearest place of the curve.
constexpr int kPasses = 6;

using Points = std::span<const Vec2>;

Vec2 direction(Vec2 v) {
    const double size = length(v);
    return size > 0.0 ? (1.0 / size) * v : Vec2{};
}

/// Returns the number of steps from one end of the points to a place at least `reach` along them; at least one, at most
/// to the other end. `back`: from the last point backwards.
std::size_t stepsAlong(Points points, double reach, bool back) {
    const std::size_t last = points.size() - 1;
    const auto at = [&](std::size_t k) { return points[back ? last - k : k]; };
    double along = 0.0;
    std::size_t k = 0;
    while (k < last && (k == 0 || along < reach)) {
        along += distance(at(k), at(k + 1));
        ++k;
    }
    return k;
}

/// Returns the direction of the points around number `k` over a length to both sides.
Vec2 tangentAround(Points points, std::size_t k, double reach) {
    const std::size_t before = stepsAlong(points.first(k + 1), reach, true);
    const std::size_t after = stepsAlong(points.subspan(k), reach, false);
    const Vec2 along = direction(points[k + after] - points[k - before]);
    return along != Vec2{} ? along : direction(points[k + after] - points[k]);
}

/// Returns the direction into the points at their first one, or from their last one backwards: that of the parabola
/// through the ends of a window that is nearest to the points between.
Vec2 tangentAtEnd(Points points, double reach, bool back) {
    const std::size_t count = std::min(std::max<std::size_t>(stepsAlong(points, reach, back), 2), points.size() - 1);
    const auto at = [&](std::size_t k) { return points[back ? points.size() - 1 - k : k]; };
    double whole = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        whole += distance(at(k), at(k + 1));
    }
    Vec2 sum{};
    double weight = 0.0, along = 0.0;
    for (std::size_t k = 1; k < count; ++k) {
        along += distance(at(k - 1), at(k));
        const double t = along / whole, b = 2.0 * t * (1.0 - t);
        sum += b * (at(k) - (1.0 - t) * (1.0 - t) * at(0) - t * t * at(count));
        weight += b * b;
    }
    const Vec2 control = weight > 0.0 ? (1.0 / weight) * sum : at(count);
    const Vec2 along0 = direction(control - at(0));
    return along0 != Vec2{} ? along0 : direction(at(count) - at(0));
}

/// Returns the turn at point `k` between what lies `reach` before and after it; 0 near the ends.
double turnAt(Points points, std::size_t k, double reach) {
    const std::size_t before = stepsAlong(points.first(k + 1), reach, true);
    const std::size_t after = stepsAlong(points.subspan(k), reach, false);
    const Vec2 from = points[k] - points[k - before], to = points[k + after] - points[k];
    const bool inside = length(from) > 0.5 * reach && length(to) > 0.5 * reach;
    const double turn = std::fabs(std::atan2(cross(from, to), dot(from, to)));
    // A hairpin is short in its middle, but a corner all the same.
    return inside || turn > 0.5 * std::numbers::pi ? turn : 0.0;
}

/// Returns the numbers of the points at which the stroke has a corner. The first and the last point are none.
std::vector<std::size_t> cornersOf(Points points, double window) {
    std::vector<double> turns(points.size(), 0.0);
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
        const double turn = turnAt(points, k, window);
        turns[k] = turn > kCornerTurn && turnAt(points, k, 0.5 * window) > kNearTurn ? turn : 0.0;
    }
    std::vector<std::size_t> corners;
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
        const std::size_t first = k - stepsAlong(points.first(k + 1), window, true);
        const std::size_t last = k + stepsAlong(points.subspan(k), window, false);
        bool sharpest = turns[k] > 0.0;
        for (std::size_t j = first; j <= last && sharpest; ++j) {
            const bool near = distance(points[j], points[k]) <= window;
            sharpest = !near || turns[j] < turns[k] || (turns[j] == turns[k] && j >= k);
        }
        if (sharpest) {
            corners.push_back(k);
        }
    }
    return corners;
}

/// A stretch of the stroke and the directions into it at both ends.
struct Stretch {
    Points points;
    Vec2 tangent0, tangent1;
};

/// Returns the parameters of the points by their distance along them.
std::vector<double> parametersAlong(Points points) {
    std::vector<double> result{0.0};
    for (std::size_t k = 1; k < points.size(); ++k) {
        result.push_back(result.back() + distance(points[k - 1], points[k]));
    }
    const double whole = result.back();
    for (double &t : result) {
        t /= whole;
    }
    return result;
}

/// Returns the cubic with the ends and tangents of a stretch that is nearest to its points at their parameters.
Curve nearestCubic(const Stretch &stretch, const std::vector<double> &parameters) {
    const Points points = stretch.points;
    const Vec2 first = points.front(), last = points.back();
    double c00 = 0.0, c01 = 0.0, c11 = 0.0, x0 = 0.0, x1 = 0.0, whole = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double t = parameters[k], s = 1.0 - t;
        const double b1 = 3.0 * t * s * s, b2 = 3.0 * t * t * s;
        const Vec2 a0 = b1 * stretch.tangent0, a1 = b2 * stretch.tangent1;
        const Vec2 rest = points[k] - ((s * s * s + b1) * first + (t * t * t + b2) * last);
        c00 += dot(a0, a0);
        c01 += dot(a0, a1);
        c11 += dot(a1, a1);
        x0 += dot(a0, rest);
        x1 += dot(a1, rest);
        whole += k > 0 ? distance(points[k - 1], points[k]) : 0.0;
    }
    const double determinant = c00 * c11 - c01 * c01;
    double arm0 = (x0 * c11 - x1 * c01) / determinant, arm1 = (c00 * x1 - c01 * x0) / determinant;
    const auto sensible = [&](double arm) { return arm > 1e-3 * whole && arm < whole; };
    if (!(determinant > 1e-12 * c00 * c11) || !sensible(arm0) || !sensible(arm1)) {
        arm0 = arm1 = whole / 3.0;
    }
    return Curve::cubic(first, first + arm0 * stretch.tangent0, last + arm1 * stretch.tangent1, last);
}

/// The point of a stretch that is farthest from a curve at its parameter.
struct Miss {
    std::size_t point = 0;
    double distance = 0.0;
};

Miss worstOf(const Curve &curve, Points points, const std::vector<double> &parameters) {
    Miss worst{points.size() / 2, 0.0};
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
        const double away = distance(curve.point(parameters[k]), points[k]);
        if (away > worst.distance) {
            worst = {k, away};
        }
    }
    return worst;
}

/// Moves each parameter towards the place of the curve nearest to its point, by a step of Newton's method.
void improve(std::vector<double> &parameters, const Curve &curve, Points points) {
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
        const Vec2 away = curve.point(parameters[k]) - points[k], speed = curve.derivative(parameters[k]);
        const double slope = dot(speed, speed) + dot(away, curve.secondDerivative(parameters[k]));
        if (slope > 0.0) {
            parameters[k] = std::clamp(parameters[k] - dot(away, speed) / slope, 0.0, 1.0);
        }
    }
}

/// Appends the cubics along a stretch without corners.
void fitSmooth(const Stretch &stretch, double tolerance, std::vector<Curve> &curves) {
    std::vector<double> parameters = parametersAlong(stretch.points);
    Curve curve = nearestCubic(stretch, parameters);
    Miss miss = worstOf(curve, stretch.points, parameters);
    for (int pass = 0; pass < kPasses && miss.distance > tolerance && miss.distance < 8.0 * tolerance; ++pass) {
        improve(parameters, curve, stretch.points);
        curve = nearestCubic(stretch, parameters);
        miss = worstOf(curve, stretch.points, parameters);
    }
    if (stretch.points.size() < 3 || miss.distance <= tolerance) {
        curves.push_back(curve);
        return;
    }
    const Vec2 middle = tangentAround(stretch.points, miss.point, 0.5 * kWindow * tolerance);
    fitSmooth({stretch.points.first(miss.point + 1), stretch.tangent0, -1.0 * middle}, tolerance, curves);
    fitSmooth({stretch.points.subspan(miss.point), middle, stretch.tangent1}, tolerance, curves);
}

/// Appends the curves between two corners or ends.
void fitBetween(Points points, double tolerance, std::vector<Curve> &curves) {
    const Vec2 first = points.front(), last = points.back();
    const bool straight = first != last && std::all_of(points.begin(), points.end(), [&](Vec2 p) {
                              return distanceToSegment(first, last, p) <= tolerance;
                          });
    if (straight) {
        curves.push_back(Curve::line(first, last));
        return;
    }
    const double window = kWindow * tolerance;
    fitSmooth({points, tangentAtEnd(points, window, false), tangentAtEnd(points, window, true)}, tolerance, curves);
}

std::vector<Vec2> withoutRepeats(Points points, bool closed) {
    std::vector<Vec2> result;
    std::unique_copy(points.begin(), points.end(), std::back_inserter(result));
    while (closed && result.size() > 1 && result.back() == result.front()) {
        result.pop_back();
    }
    return result;
}

/// Turns a closed stroke so that it begins at its first corner, if it has one, and repeats its first point at the end.
/// Returns whether that is a corner.
bool turnToCorner(std::vector<Vec2> &points, double window) {
    // Three rounds: in the middle one, every point has neighbours.
    const std::size_t n = points.size();
    std::vector<Vec2> rounds;
    for (int round = 0; round < 3; ++round) {
        rounds.insert(rounds.end(), points.begin(), points.end());
    }
    const std::vector<std::size_t> corners = cornersOf(rounds, window);
    const auto found = std::find_if(corners.begin(), corners.end(), [n](std::size_t k) { return k >= n && k < 2 * n; });
    if (found != corners.end()) {
        std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(*found - n), points.end());
    }
    points.push_back(points.front());
    return found != corners.end();
}

/// Returns the direction of a loop without corners where it begins.
Vec2 tangentAtStart(const std::vector<Vec2> &loop, double reach) {
    std::vector<Vec2> twice(loop.begin(), loop.end() - 1);
    twice.insert(twice.end(), loop.begin(), loop.end());
    return tangentAround(twice, loop.size() - 1, reach);
}

} // namespace

std::vector<Curve> fitStroke(std::span<const Vec2> points, double tolerance, bool closed) {
    std::vector<Vec2> stroke = withoutRepeats(points, closed);
    std::vector<Curve> curves;
    if (stroke.size() < 2) {
        return curves;
    }
    const double window = kWindow * tolerance;
    const bool cornered = !closed || turnToCorner(stroke, window);
    std::vector<std::size_t> corners = cornersOf(stroke, window);
    if (!cornered && corners.empty()) {
        const Vec2 start = tangentAtStart(stroke, 0.5 * window);
        fitSmooth({stroke, start, -1.0 * start}, tolerance, curves);
        return curves;
    }
    corners.push_back(stroke.size() - 1);
    std::size_t from = 0;
    for (const std::size_t to : corners) {
        fitBetween(Points(stroke).subspan(from, to - from + 1), tolerance, curves);
        from = to;
    }
    return curves;
}

} // namespace forefront
