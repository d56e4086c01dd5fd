#include "core/engine/spacing/parts/probes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace forefront {
namespace {

const char *faultOf(double value, const SpacingSpec &spec) {
    if (std::isnan(value)) {
        return "a value that is not a number";
    }
    if (value <= 0.0 && !spec.minimum) {
        return value == 0.0 ? "zero" : "a negative number";
    }
    if (std::isinf(value) && value > 0.0 && !spec.maximum) {
        return "infinity";
    }
    return nullptr;
}

} // namespace

ProbeLimits ProbeLimits::of(const SpacingSpec &spec, const Box2 &box) {
    const double floor = spec.minimum.value_or(1e-9 * box.diagonal());
    return {floor, spec.maximum.value_or(std::max(1e3 * box.diagonal(), floor))};
}

std::vector<Vec2> probePlaces(const Domain &domain, const InsideTest *inside, const Box2 &box) {
    std::vector<Vec2> places;
    for (const Vec2 node : domain.nodes) {
        if (box.contains(node)) {
            places.push_back(node);
        }
    }
    for (int j = 0; j <= kProbes; ++j) {
        for (int i = 0; i <= kProbes; ++i) {
            const Vec2 p{box.min.x + box.size().x * i / kProbes, box.min.y + box.size().y * j / kProbes};
            if (inside == nullptr || inside->contains(p)) {
                places.push_back(p);
            }
        }
    }
    return places;
}

Diagnostics probeFaults(std::span<const Vec2> places, std::span<const double> values, const SpacingSpec &spec,
                        const char *code, std::string_view what, std::string_view advice) {
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (const char *const fault = faultOf(values[i], spec)) {
            Diagnostics faults =
                error(code, "the " + std::string(what) + " gives " + fault + "; expected a number above 0",
                      std::string(advice));
            faults.front().at = places[i];
            return faults;
        }
    }
    return {};
}

} // namespace forefront
