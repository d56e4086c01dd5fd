#include "core/engine/geometry/curve_part.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace forefront {

namespace {

struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

/// Returns the extent of points along an axis, relative to an origin.
Extent extentOf(std::span<const Vec2> points, Vec2 origin, Vec2 axis) {
    Extent extent;
    for (const Vec2 p : points) {
        const double x = dot(axis, p - origin);
        extent.low = std::min(extent.low, x);
        extent.high = std::max(extent.high, x);
    }
    return extent;
}

/// Returns the rounding error of points on a curve, which is large for a circle with a distant centre.
double noiseOf(const Curve &curve) {
    double largest = 0.0;
    const auto numbers = curve.numbers();
    const std::size_t places = curve.kind() == CurveKind::Arc ? 6 : 8;
    for (std::size_t k = 0; k < places; ++k) {
        largest = std::max(largest, std::fabs(numbers[k]));
    }
    return 16.0 * std::numeric_limits<double>::epsilon() * largest;
}

} // namespace

double curvatureOf(const Curve &curve, double t) {
    const Vec2 d = curve.derivative(t);
    const double speed = length(d);
    return speed > 0.0 ? cross(d, curve.secondDerivative(t)) / (speed * speed * speed) : 0.0;
}

CurvePart::CurvePart(const Curve &of, double from, double to)
    : curve(of), t0(std::min(from, to)), t1(std::max(from, to)), start(of.point(t0)), end(of.point(t1)),
      noise(noiseOf(of)) {
    const auto numbers = curve.numbers();
    switch (curve.kind()) {
    case CurveKind::Line:
        corners = {start, end};
        cornerCount = 2;
        break;
    case CurveKind::Arc: {
        constexpr double kWidest = 1.3; // half of what the arc turns before affine maps
        const double half = 0.5 * numbers[7] * (t1 - t0);
        if (std::fabs(half) < kWidest) { // the tangents at the ends meet in the third corner
            corners = {start, start + (std::tan(half) / numbers[7]) * curve.derivative(t0), end};
            cornerCount = 3;
        } else {
            const Box2 box = curve.bounds(t0, t1);
            corners = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
            cornerCount = 4;
            turn = std::numbers::pi;
        }
        break;
    }
    case CurveKind::Cubic: {
        const auto part = curve.part(t0, t1).numbers();
        corners = {start, {part[2], part[3]}, {part[4], part[5]}, end};
        cornerCount = 4;
        break;
    }
    }
    const double chord = distance(start, end);
    if (!(chord > 0.0)) {
        turn = curve.kind() == CurveKind::Line ? 0.0 : std::numbers::pi;
        sagitta = size();
        return;
    }
    along = (1.0 / chord) * (end - start);
    for (std::size_t k = 0; k < cornerCount; ++k) {
        sagitta = std::max(sagitta, std::fabs(cross(along, corners[k] - start)));
        const Vec2 edge = k == 0 ? Vec2{} : corners[k] - corners[k - 1];
        if (edge != Vec2{}) { // of the corners in order; tangents are between these directions
            turn = std::max(turn, std::atan2(std::fabs(cross(along, edge)), dot(along, edge)));
        }
    }
}

double CurvePart::size() const {
    const Extent x = extentOf(hull(), start, along), y = extentOf(hull(), start, leftNormal(along));
    return std::max(x.high - x.low, y.high - y.low);
}

bool apart(const CurvePart &first, const CurvePart &second, double gap) {
    for (const Vec2 axis : {first.along, leftNormal(first.along), second.along, leftNormal(second.along)}) {
        const Extent s = extentOf(first.hull(), first.start, axis), t = extentOf(second.hull(), first.start, axis);
        if (t.low - s.high > gap || s.low - t.high > gap) {
            return true;
        }
    }
    return false;
}

CurveGraph::CurveGraph(const CurvePart &part, Vec2 origin, Vec2 axis) : part_(&part), origin_(origin), axis_(axis) {
    low_ = place(part.t0);
    high_ = place(part.t1);
    forward_ = low_ <= high_;
    if (!forward_) {
        std::swap(low_, high_);
    }
}

/// Newton's method within a bracket that shrinks at every step.
CurveGraph::Value CurveGraph::at(double x) const {
    constexpr int kSteps = 100;
    const Curve &curve = part_->curve;
    double before = forward_ ? part_->t0 : part_->t1, beyond = forward_ ? part_->t1 : part_->t0;
    const double share = high_ > low_ ? std::clamp((x - low_) / (high_ - low_), 0.0, 1.0) : 0.0;
    double t = share == 1.0 ? beyond : std::lerp(before, beyond, share);
    for (int step = 0; step < kSteps && x > low_ && x < high_; ++step) {
        const double off = place(t) - x;
        if (off == 0.0) {
            break;
        }
        (off < 0.0 ? before : beyond) = t;
        double next = t - off / dot(axis_, curve.derivative(t));
        if (!(next > std::min(before, beyond) && next < std::max(before, beyond))) {
            next = std::midpoint(before, beyond);
        }
        const bool settled = std::fabs(next - t) <= std::numeric_limits<double>::epsilon();
        t = next;
        if (settled) {
            break;
        }
    }
    const Vec2 first = curve.derivative(t), second = curve.secondDerivative(t);
    const double dx = dot(axis_, first), dy = cross(axis_, first);
    const double bend = (dx * cross(axis_, second) - dy * dot(axis_, second)) / (dx * dx * dx);
    return {t, cross(axis_, curve.point(t) - origin_), dy / dx, bend};
}

} // namespace forefront
