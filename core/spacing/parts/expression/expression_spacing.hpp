#pragma once

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/domain/domain.hpp"
#include "core/spacing/parts/expression/expression_program.hpp"
#include "core/spacing/sites/site_set.hpp"
#include "core/spacing/spec/spacing_spec.hpp"

#include <string>

namespace forefront {

/// An expression as spacing: always finite and > 0, whatever the formula gives between the probed places.
class ExpressionSpacing {
  public:
    /// Compiles `spec.expression` and probes it at 65 x 65 places of the box and at the domain's nodes. Faults:
    /// expression-syntax; expression-value with the first bad place: NaN anywhere, values <= 0 unless a minimum is
    /// given, infinity unless a maximum is given.
    static Result<ExpressionSpacing> build(const SpacingSpec &spec, const Domain &domain, const Box2 &box);

    double at(Vec2 p) const { return made(program_.evaluate(p)); }
    void atMany(std::span<const Vec2> points, std::span<double> rho) const;
    const std::string &text() const { return text_; }
    /// Places from which the spacing reaches on by `gradation` where the formula is steeper: found on a lattice that is
    /// refined to a part of the spacing itself, so that the limited spacing is exact within about 2 %.
    void addSteepSites(const Box2 &box, double gradation, SiteSet &sites, const Progress &progress) const;
    /// Bounds over the box it was built for: by interval arithmetic on 64 x 64 parts of it, or as probed where that
    /// gives nothing finite.
    double minimum() const { return minimum_; }
    double maximum() const { return maximum_; }

  private:
    void findBounds(const Box2 &box);
    // Written so that NaN becomes the ceiling.
    double made(double value) const {
        const double low = value < floor_ ? floor_ : value;
        return low <= ceiling_ ? low : ceiling_;
    }

    ExpressionProgram program_;
    std::string text_;
    double floor_ = 0.0;   ///< 1e-9 of the box's diagonal, or the minimum given
    double ceiling_ = 0.0; ///< 1e3 of the diagonal, or the maximum given
    double minimum_ = 0.0;
    double maximum_ = 0.0;
};

} // namespace forefront
