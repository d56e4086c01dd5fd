#include "core/engine/spacing/parts/expression/expression_spacing.hpp"

#include "core/engine/spacing/parts/expression/expression.hpp"

#include <cmath>
#include <limits>

namespace forefront {
namespace {

constexpr int kProbes = 64; ///< intervals of the probing grid along each side

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

Result<ExpressionSpacing> ExpressionSpacing::build(const SpacingSpec &spec, const Domain &domain,
                                                   const InsideTest *inside, const Box2 &box) {
    auto program = compileExpression(*spec.expression, spec.names);
    if (!program) {
        return program.faults();
    }
    ExpressionSpacing spacing;
    spacing.program_ = std::move(*program);
    spacing.text_ = *spec.expression;
    spacing.floor_ = spec.minimum.value_or(1e-9 * box.diagonal());
    spacing.ceiling_ = spec.maximum.value_or(std::max(1e3 * box.diagonal(), spacing.floor_));

    const std::vector<Vec2> places = probePlaces(domain, inside, box);
    std::vector<double> values(places.size());
    spacing.program_.evaluateMany(places, values);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (const char *const fault = faultOf(values[i], spec)) {
            Diagnostics faults =
                error("expression-value",
                      std::string("the spacing expression gives ") + fault + "; expected a number above 0",
                      "keep it above zero everywhere in the domain, for example with max(0.1, ...)");
            faults.front().at = places[i];
            return faults;
        }
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
            low = std::min(low, clamped(range.low));
            high = std::max(high, clamped(range.high));
        }
    }
    minimum_ = low;
    maximum_ = high;
}

void ExpressionSpacing::atMany(std::span<const Vec2> points, std::span<double> rho) const {
    program_.evaluateMany(points, rho);
    for (double &value : rho) {
        value = clamped(value);
    }
}

} // namespace forefront
