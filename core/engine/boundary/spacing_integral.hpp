#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/geometry/curve.hpp"
#include "core/engine/spacing/spacing_field.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace forefront {

/// The part of a curve that is to be divided.
struct CurvePath {
    const Curve *curve = nullptr;
    double t0 = 0.0;
    double t1 = 1.0;
    double tolerance = 0.0; ///< maximum distance of a piece from the curve, in domain units

    Vec2 at(double fraction) const { return curve->point(std::lerp(t0, t1, fraction)); }
    /// Returns the number of pieces per unit of the fraction that the spacing `rho` and the curvature call for.
    double density(double fraction, double rho) const;
    /// Returns the distance of a piece from the curve.
    double deviation(double from, double to) const {
        return curve->deviation(std::lerp(t0, t1, from), std::lerp(t0, t1, to));
    }
    /// Returns true if a piece is close enough to the curve and does not turn too far.
    bool allows(double from, double to) const;
};

/// The integral N(t) = ∫ds/ρ from the start of a segment to the fraction t of its length: the number of pieces that the
/// spacing calls for up to there.
///
/// Sampled until no interval is longer than ρ at its ends and middle, and more finely where ρ more than doubles; the
/// density is linear in between. Accurate to a few parts in a thousand if |∇ρ| <= 0.3, however much ρ varies along the
/// segment.
class SpacingIntegral {
  public:
    enum class Outcome : std::uint8_t { Done, BadSpacing, TooMany, Cancelled };

    /// Integrates along ab. `rhoA` and `rhoB` are the spacings at the ends. No interval is longer than `longest` (> 0,
    /// domain units); narrower dips of ρ may be missed. Returns TooMany once the integral exceeds `limit`, BadSpacing
    /// if ρ is not finite and positive somewhere.
    Outcome integrate(const SpacingField &spacing, Vec2 a, Vec2 b, double rhoA, double rhoB, double longest,
                      double limit, const Progress &progress);

    /// Integrates along a curve, as above, and adds the pieces that its curvature calls for.
    Outcome integrate(const SpacingField &spacing, const CurvePath &path, double longest, double limit,
                      const Progress &progress);

    /// Returns the integral over the whole segment.
    double total() const { return samples_.back().integral; }
    /// Returns the place where ρ was invalid, after BadSpacing.
    Vec2 badPlace() const { return badPlace_; }

    /// Returns the number of pieces (>= 1) whose length is closest in ratio to the spacing.
    double pieces() const;

    /// Sets `fractions` to the count - 1 cuts between `count` pieces with equal shares of the integral.
    void cut(std::uint32_t count, std::vector<double> &fractions) const;

  private:
    struct Sample {
        double t = 0.0;
        double density = 0.0; ///< dN/dt
        double integral = 0.0;
    };
    struct Interval {
        double t0 = 0.0, t1 = 0.0, density0 = 0.0, density1 = 0.0;
    };

    template <class Path>
    Outcome follow(const SpacingField &spacing, const Path &path, double densityA, double densityB, double longestStep,
                   double limit, const Progress &progress);
    void append(double t, double density);
    Outcome fail(Vec2 place);

    std::vector<Sample> samples_;
    std::vector<Interval> stack_;
    Vec2 badPlace_;
};

/// Returns ∫ds/ρ over a segment from at most 4096 samples, within about 10 %; not finite if ρ is 0 or NaN somewhere.
double roughSpacingIntegral(const SpacingField &spacing, Vec2 a, Vec2 b, double rhoA, double rhoB);

} // namespace forefront
