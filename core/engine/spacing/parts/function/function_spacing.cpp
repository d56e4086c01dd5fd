#include "core/engine/spacing/parts/function/function_spacing.hpp"

#include <algorithm>
#include <vector>

namespace forefront {

Result<FunctionSpacing> FunctionSpacing::build(const SpacingSpec &spec, const Domain &domain, const InsideTest *inside,
                                               const Box2 &box) {
    FunctionSpacing spacing;
    spacing.one_ = spec.function;
    spacing.many_ = spec.bulkFunction;
    spacing.limits_ = ProbeLimits::of(spec, box);

    const std::vector<Vec2> places = probePlaces(domain, inside, box);
    std::vector<double> values(places.size());
    spacing.call(places, values);
    if (Diagnostics faults = probeFaults(places, values, spec, "function-value", "size function",
                                         "return a positive size everywhere in the domain");
        !faults.empty()) {
        return faults;
    }
    const auto clamp = [&](double value) { return spacing.limits_.clamped(value); };
    std::transform(values.begin(), values.end(), values.begin(), clamp);
    spacing.minimum_ = *std::min_element(values.begin(), values.end());
    spacing.maximum_ = *std::max_element(values.begin(), values.end());
    return spacing;
}

double FunctionSpacing::at(Vec2 p) const {
    double rho = 0.0;
    call({&p, 1}, {&rho, 1});
    return limits_.clamped(rho);
}

void FunctionSpacing::call(std::span<const Vec2> points, std::span<double> sizes) const {
    if (many_) {
        many_(points, sizes);
        return;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        sizes[i] = one_(points[i]);
    }
}

void FunctionSpacing::atMany(std::span<const Vec2> points, std::span<double> rho) const {
    call(points, rho);
    for (double &value : rho) {
        value = limits_.clamped(value);
    }
}

} // namespace forefront
