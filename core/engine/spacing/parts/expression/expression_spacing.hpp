#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/domain/inside_test.hpp"
#include "core/engine/spacing/parts/expression/expression_program.hpp"
#include "core/engine/spacing/parts/probes.hpp"
#include "core/engine/spacing/sites/site_words.hpp"

#include <string>

namespace forefront {

/// An expression as spacing: always finite and > 0, even where the formula is not at places between the probes.
class ExpressionSpacing {
  public:
    /// Compiles `spec.expression` and evaluates it at the domain's nodes and at the points of a 65 x 65 grid over the
    /// box that are inside the domain; at all of them if `inside` is null, because the inside is unknown. Errors:
    /// expression-syntax; expression-value at the first place with NaN, a value <= 0 without a minimum, or infinity
    /// without a maximum; raster-gap where a raster that it calls has no value in or near the domain.
    static Result<ExpressionSpacing> build(const SpacingSpec &spec, const Domain &domain, const InsideTest *inside,
                                           const Box2 &box);

    double at(Vec2 p) const { return limits_.clamped(program_.evaluate(p)); }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const;
    SpacingSample sample(Vec2 p, const SiteWords &) const {
        return {at(p), SpacingOrigin::Expression, 0, "expression " + text_};
    }
    /// Returns a lower bound over the domain, by interval arithmetic on the cells of a 64 x 64 grid over its box that
    /// meet the inside, or the smallest probed value where that is undefined, or not positive beside the boundary.
    double minimum() const { return minimum_; }
    double maximum() const { return maximum_; }

  private:
    void findBounds(const InsideTest *inside, const Box2 &box);

    ExpressionProgram program_;
    std::string text_;
    ProbeLimits limits_;
    double minimum_ = 0.0;
    double maximum_ = 0.0;
};

} // namespace forefront
