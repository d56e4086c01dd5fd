#include "core/engine/domain/element_places.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace forefront {

std::vector<double> elementPlaces(std::uint32_t count, const ElementBias &bias) {
    // Factor between the lengths of neighbours.
    const std::uint32_t steps = bias.bothEnds ? (count - 1) / 2 : count - 1;
    const double factor = steps > 0 ? std::pow(bias.ratio, 1.0 / steps) : 1.0;
    std::vector<double> places{0.0};
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t fromEnd = bias.bothEnds ? std::min(k, count - 1 - k) : k;
        places.push_back(places.back() + std::pow(factor, fromEnd));
    }
    const double whole = places.back();
    for (double &place : places) {
        place /= whole;
    }
    return places;
}

double elementsBefore(const std::vector<double> &places, double fraction) {
    const auto after = std::upper_bound(places.begin() + 1, places.end() - 1, fraction);
    const double from = *(after - 1), to = *after;
    return static_cast<double>(after - places.begin() - 1) + (fraction - from) / (to - from);
}

double placeOfElement(const std::vector<double> &places, double elements) {
    const double last = static_cast<double>(places.size()) - 2.0;
    const double whole = std::clamp(std::floor(elements), 0.0, last);
    const auto k = static_cast<std::size_t>(whole);
    return std::lerp(places[k], places[k + 1], elements - whole);
}

double parameterAtLength(const Curve &curve, double fraction) {
    if (curve.kind() == CurveKind::Line || fraction <= 0.0 || fraction >= 1.0) {
        return std::clamp(fraction, 0.0, 1.0);
    }
    constexpr int kMaxSteps = 60; // as many as halving needs, but Newton's method needs about five
    const double wanted = fraction * curve.length();
    double low = 0.0, high = 1.0, t = fraction;
    for (int step = 0; step < kMaxSteps && high - low > 1e-14; ++step) {
        const double miss = curve.length(0.0, t) - wanted;
        (miss < 0.0 ? low : high) = t;
        const double speed = length(curve.derivative(t));
        const double next = t - miss / speed;
        if (std::fabs(miss) <= 1e-13 * wanted) {
            break;
        }
        t = next > low && next < high ? next : std::midpoint(low, high);
    }
    return t;
}

} // namespace forefront
