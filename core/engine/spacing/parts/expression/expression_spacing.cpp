#include "core/engine/spacing/parts/expression/expression_spacing.hpp"

#include "core/engine/spacing/parts/expression/expression.hpp"

#include <algorithm>
#include <limits>

namespace forefront {

Result<ExpressionSpacing> ExpressionSpacing::build(const SpacingSpec &spec, const Domain &domain,
                                                   const InsideTest *inside, const Box2 &box) {
    auto program = compileSpacingExpression(*spec.expression, spec, &domain);
    if (!program) {
        return program.faults();
    }
    for (const auto &function : program->functions()) {
        if (Diagnostics faults = function->gaps(domain, inside); !faults.empty()) {
            return faults;
        }
    }
    ExpressionSpacing spacing;
    spacing.program_ = std::move(*program);
    spacing.text_ = *spec.expression;
    spacing.limits_ = ProbeLimits::of(spec, box);

    const std::vector<Vec2> places = probePlaces(domain, inside, box);
    std::vector<double> values(places.size());
    spacing.program_.evaluateMany(places, values);
    if (Diagnostics faults = probeFaults(places, values, spec, "expression-value", "spacing expression",
                                         "keep it above zero everywhere in the domain, for example with max(0.1, ...)");
        !faults.empty()) {
        return faults;
    }
    spacing.atMany(places, values);
    spacing.minimum_ = *std::min_element(values.begin(), values.end());
    spacing.maximum_ = *std::max_element(values.begin(), values.end());
    spacing.findBounds(inside, box);
    return spacing;
}

void ExpressionSpacing::findBounds(const InsideTest *inside, const Box2 &box) {
    double low = minimum_, high = maximum_;
    for (int j = 0; j < kProbes; ++j) {
        for (int i = 0; i < kProbes; ++i) {
            const Vec2 corner = box.min + Vec2{box.size().x * i / kProbes, box.size().y * j / kProbes};
            const Box2 part{corner, corner + Vec2{box.size().x / kProbes, box.size().y / kProbes}};
            if (inside != nullptr && !inside->meets(part)) {
                continue;
            }
            const ValueRange range = program_.range(part);
            if ((range.undefined || !(range.low > 0.0)) && inside != nullptr && inside->boundaryMeets(part)) {
                continue; // it may be so only outside
            }
            if (range.undefined) {
                return;
            }
            low = std::min(low, limits_.clamped(range.low));
            high = std::max(high, limits_.clamped(range.high));
        }
    }
    minimum_ = low;
    maximum_ = high;
}

void ExpressionSpacing::atMany(std::span<const Vec2> points, std::span<double> rho) const {
    program_.evaluateMany(points, rho);
    for (double &value : rho) {
        value = limits_.clamped(value);
    }
}

} // namespace forefront
