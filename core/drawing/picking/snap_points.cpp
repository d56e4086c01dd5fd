#include "core/drawing/picking/snap_points.hpp"

#include "core/drawing/shapes/curve_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

namespace forefront {
namespace {

bool isClosed(const Curve &curve) {
    constexpr double kWhole = 2.0 * std::numbers::pi - 1e-12;
    return curve.kind() == CurveKind::Arc && std::fabs(curve.numbers()[7]) >= kWhole;
}

/// Returns the change of a parameter that rounding of the coordinates alone may cause.
double roundingAt(const Curve &curve, double t) {
    const Box2 box = curve.bounds();
    const double magnitude = std::max(length(box.min), length(box.max));
    return std::max(1e-14, 16.0 * std::numeric_limits<double>::epsilon() * magnitude / length(curve.derivative(t)));
}

/// Returns the parameter near `t` where a function of the parameter vanishes, by Newton's method; none if it does not
/// converge on the curve.
template <class Function>
std::optional<double> rootNear(const Curve &curve, double t, const Function &valueAndSlope) {
    const bool closed = isClosed(curve);
    const double converged = roundingAt(curve, t);
    constexpr int kSteps = 30;
    for (int step = 0; step < kSteps; ++step) {
        const auto [value, slope] = valueAndSlope(t);
        if (slope == 0.0 || !std::isfinite(value / slope)) {
            return std::nullopt;
        }
        const double by = value / slope;
        t -= by;
        t -= closed ? std::floor(t) : 0.0;
        if (std::fabs(by) <= converged) {
            const double inside = std::clamp(t, 0.0, 1.0);
            return std::fabs(inside - t) <= converged ? std::optional(inside) : std::nullopt;
        }
        if (!closed && (t < -1.0 || t > 2.0)) {
            return std::nullopt;
        }
    }
    return std::nullopt;
}

struct ValueAndSlope {
    double value = 0.0, slope = 0.0;
};

/// Collects candidates and keeps the nearest.
class NearestCandidate {
  public:
    explicit NearestCandidate(const SnapQuery &query) : query_(query), limit_(query.tolerance) {}

    void offer(Vec2 at, SnapKind kind, std::optional<Vec2> from = {}) {
        const double away = distance(at, query_.at);
        if (away < limit_ || (away == limit_ && !best_)) {
            limit_ = away;
            best_ = Snapped{at, kind, {}, from};
        }
    }
    const std::optional<Snapped> &best() const { return best_; }

  private:
    const SnapQuery &query_;
    double limit_;
    std::optional<Snapped> best_;
};

/// Offers where a line from the anchor meets a curve at a right angle, and where it touches the curve. A curve that
/// begins at the anchor meets the line there, which does not count.
void offerDirections(const Curve &curve, Vec2 anchor, Vec2 pointer, NearestCandidate &nearest) {
    const double start = curve.nearest(pointer);
    const double apart = 1e-9 * curve.bounds().diagonal();
    const auto perpendicular = rootNear(curve, start, [&](double t) {
        const Vec2 arm = curve.point(t) - anchor, along = curve.derivative(t);
        return ValueAndSlope{dot(arm, along), dot(along, along) + dot(arm, curve.secondDerivative(t))};
    });
    if (perpendicular && distance(curve.point(*perpendicular), anchor) > apart) {
        nearest.offer(curve.point(*perpendicular), SnapKind::Perpendicular, anchor);
    }
    if (curve.kind() == CurveKind::Line) {
        return;
    }
    const auto tangent = rootNear(curve, start, [&](double t) {
        const Vec2 arm = curve.point(t) - anchor;
        return ValueAndSlope{cross(arm, curve.derivative(t)), cross(arm, curve.secondDerivative(t))};
    });
    if (tangent && distance(curve.point(*tangent), anchor) > apart) {
        nearest.offer(curve.point(*tangent), SnapKind::Tangent, anchor);
    }
}

} // namespace

std::optional<Snapped> specialPoint(const PickIndex &index, const SnapQuery &query) {
    constexpr std::size_t kMaxCurves = 8; // more are a cluster at this zoom
    const std::vector<Curve> curves = index.curvesNear(query.at, query.tolerance, kMaxCurves, query.filter);
    NearestCandidate nearest(query);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        for (std::size_t k = i + 1; k < curves.size(); ++k) {
            for (const CurveCrossing &crossing : crossingsOf(curves[i], curves[k], 1e-6 * query.tolerance)) {
                nearest.offer(crossing.at, SnapKind::Intersection);
            }
        }
    }
    for (const Curve &curve : curves) {
        if (!isClosed(curve)) {
            nearest.offer(curve.point(0.5), SnapKind::Midpoint);
        }
        for (const Vec2 from : query.lines) {
            offerDirections(curve, from, query.at, nearest);
        }
    }
    if (const std::optional<Vec2> centre = index.centre(query.at, query.tolerance, query.filter)) {
        nearest.offer(*centre, SnapKind::Centre);
    }
    return nearest.best();
}

} // namespace forefront
