#include "core/engine/domain/chord_limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace forefront {

double ChordLimit::longest(double curvature, double tolerance) {
    // The sagitta of a chord is chord² · curvature / 8.
    const double fine = std::min(std::sqrt(8.0 * tolerance / curvature), kMaxTurn / curvature);
    const double tiny = std::sqrt(8.0 * kTiny * tolerance / curvature);
    return std::min(std::max(fine, tiny), kMaxTinyTurn / curvature);
}

double ChordLimit::longestAt(const Curve &curve, double t, double tolerance) {
    const double curvature = curvatureAt(curve, t);
    if (!std::isfinite(curvature)) {
        return 0.0;
    }
    return curvature > 0.0 ? longest(curvature, tolerance) : std::numeric_limits<double>::infinity();
}

double curvatureAt(const Curve &curve, double t) {
    const Vec2 first = curve.derivative(t);
    const double speed = length(first);
    return std::fabs(cross(first, curve.secondDerivative(t))) / (speed * speed * speed);
}

} // namespace forefront
