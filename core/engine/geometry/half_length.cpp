#include "core/engine/geometry/half_length.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace forefront {

double halfLength(const Curve &curve, double t0, double t1) {
    const double start = std::min(t0, t1), end = std::max(t0, t1);
    const double half = 0.5 * curve.length(start, end);
    constexpr double kPrecision = 1e-12; // of Curve::length()
    constexpr int kMaxSteps = 100;
    double low = start, high = end, t = std::midpoint(start, end); // of lines and circles, it is the middle
    for (int step = 0; step < kMaxSteps && low < high; ++step) {
        const double excess = curve.length(start, t) - half;
        if (std::fabs(excess) <= kPrecision * half) {
            break;
        }
        (excess > 0.0 ? high : low) = t;
        const double speed = length(curve.derivative(t)); // zero at a cusp
        const double newton = speed > 0.0 ? t - excess / speed : low;
        const double next = newton > low && newton < high ? newton : std::midpoint(low, high);
        if (next == t) {
            break;
        }
        t = next;
    }
    return t;
}

} // namespace forefront
