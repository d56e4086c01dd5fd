#include "ui/canvas/glide.hpp"

#include <cmath>

namespace forefront {

Camera Glide::next(const Camera &target, std::uint64_t jumps, double now, bool smooth) {
    constexpr double kSeconds = 0.12;
    if (jumps != jumps_) {
        jumps_ = jumps;
        from_ = shown_;
        begin_ = smooth && from_.viewport == target.viewport ? now : -1e300;
    }
    const double left = 1.0 - (now - begin_) / kSeconds;
    moving_ = left > 0.0 && smooth;
    shown_ = target;
    if (moving_) {
        const double done = 1.0 - left * left * left;
        shown_.zoom = from_.zoom * std::pow(target.zoom / from_.zoom, done);
        // A place that both cameras show at the same pixel stays there.
        const double a = 1.0 / from_.zoom, b = 1.0 / target.zoom;
        const double way = std::abs(b - a) > 1e-9 * a ? (1.0 / shown_.zoom - a) / (b - a) : done;
        shown_.centre = lerp(from_.centre, target.centre, way);
    }
    return shown_;
}

} // namespace forefront
