#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/parts/probes.hpp"
#include "core/engine/spacing/sites/site_words.hpp"
#include "core/engine/spacing/sites/steep_sites.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <span>

namespace forefront {

/// A function of the caller as spacing: always finite and > 0, even where the function is not, between the probes.
/// Every member that calls the function propagates its exceptions.
class FunctionSpacing {
  public:
    /// Calls the function of `spec` at the domain's nodes and at the points of a 65 x 65 grid over the box that are
    /// inside the domain; at all of them if `inside` is null. Error: function-value at the first place with NaN, a
    /// value <= 0 without a minimum, or infinity without a maximum.
    static Result<FunctionSpacing> build(const SpacingSpec &spec, const Domain &domain, const InsideTest *inside,
                                         const Box2 &box);

    double at(Vec2 p) const;
    void atMany(std::span<const Vec2> points, std::span<double> rho) const;
    SpacingSample sample(Vec2 p, const SiteWords &) const {
        return {at(p), SpacingOrigin::Function, 0, "size function"};
    }
    /// Returns the smallest value at the probes, since nothing more is known about the function.
    double minimum() const { return minimum_; }
    double maximum() const { return maximum_; }

  private:
    void call(std::span<const Vec2> points, std::span<double> sizes) const;

    std::function<double(Vec2)> one_; ///< one of the two is given
    SizesAt many_;
    ProbeLimits limits_;
    double minimum_ = 0.0;
    double maximum_ = 0.0;
};

} // namespace forefront
