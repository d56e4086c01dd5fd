#include "core/teaching/tables/power_law.hpp"

#include <cmath>

namespace forefront {

double PowerLaw::at(double x) const {
    return factor * std::pow(x, exponent);
}

std::optional<PowerLaw> fitPowerLaw(std::span<const Vec2> points) {
    const auto count = static_cast<double>(points.size());
    Vec2 mean;
    for (const Vec2 p : points) {
        if (!(p.x > 0.0 && p.y > 0.0)) {
            return std::nullopt;
        }
        mean += (1.0 / count) * Vec2{std::log(p.x), std::log(p.y)};
    }
    double xx = 0.0, xy = 0.0;
    for (const Vec2 p : points) {
        const Vec2 d = Vec2{std::log(p.x), std::log(p.y)} - mean;
        xx += d.x * d.x;
        xy += d.x * d.y;
    }
    if (points.size() < 2 || !(xx > 1e-12)) {
        return std::nullopt;
    }
    const double exponent = xy / xx;
    return PowerLaw{std::exp(mean.y - exponent * mean.x), exponent};
}

} // namespace forefront
