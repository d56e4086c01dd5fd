#pragma once

#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>

namespace forefront::testing {

/// A spacing field from any function, for tests that only need ρ.
class SpacingFunction : public SpacingField {
  public:
    SpacingFunction(std::function<double(Vec2)> rho, double minimum, double maximum)
        : rho_(std::move(rho)), minimum_(minimum), maximum_(maximum) {}

    double at(Vec2 p) const override { return rho_(p); }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const override {
        for (std::size_t i = 0; i < points.size(); ++i) {
            rho[i] = rho_(points[i]);
        }
    }
    SpacingSample sample(Vec2 p) const override { return {rho_(p), SpacingOrigin::Expression, 0, "test"}; }
    double minimum() const override { return minimum_; }
    double maximum() const override { return maximum_; }

  private:
    std::function<double(Vec2)> rho_;
    double minimum_, maximum_;
};

inline SpacingFunction constantSpacing(double rho) {
    return {[rho](Vec2) { return rho; }, rho, rho};
}

/// Returns ρ = max(minimum, growth · distance to `centre`), which is steep and has a kink.
inline SpacingFunction spacingAround(Vec2 centre, double minimum, double growth) {
    return {[=](Vec2 p) { return std::fmax(minimum, growth * distance(p, centre)); }, minimum,
            std::numeric_limits<double>::infinity()};
}

/// Returns the spacing in a domain, which must be valid.
inline std::shared_ptr<const SpacingField> fieldOf(const SpacingSpec &spec, const Domain &domain) {
    auto field = SpacingField::build(spec, domain);
    REQUIRE_MESSAGE(field.ok(), toString(field.ok() ? Diagnostic{} : field.faults().front()));
    return *std::move(field);
}

} // namespace forefront::testing
