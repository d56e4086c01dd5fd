#pragma once

#include "core/base/progress.hpp"
#include "core/spacing/spacing_field.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// N(t) = ∫ds/ρ from the start of a segment to the fraction t of its length: the number of pieces that the spacing asks
/// for up to there. Sampled until no interval is longer than ρ at its ends and middle, shorter ones where ρ more than
/// doubles, and linear density in between: with |∇ρ| <= 0.3 within some parts in a thousand, however steeply ρ changes
/// along the whole.
class SpacingIntegral {
  public:
    enum class Outcome : std::uint8_t { Done, BadSpacing, TooMany, Cancelled };

    /// `rhoA`, `rhoB`: spacing at the ends. No interval is longer than `longest` (> 0, domain units): narrower dips of
    /// ρ may be missed. TooMany once the integral exceeds `most`; BadSpacing where ρ is not finite
    /// and positive.
    Outcome integrate(const SpacingField &spacing, Vec2 a, Vec2 b, double rhoA, double rhoB, double longest,
                      double most, const Progress &progress);

    double total() const { return samples_.back().integral; }
    /// Where ρ was bad.
    Vec2 badPlace() const { return badPlace_; }

    /// Number of pieces (>= 1) whose length comes closest to the spacing, too long and too short weighed alike.
    double pieces() const;

    /// Replaces `fractions` by those of the count - 1 inner ends of `count` pieces with equal shares of the integral.
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

    void append(double t, double density);
    Outcome fail(Vec2 place);

    std::vector<Sample> samples_;
    std::vector<Interval> stack_;
    Vec2 badPlace_;
};

/// About ∫ds/ρ over a segment from few samples, however large it is; infinite or NaN where ρ is bad.
double roughSpacingIntegral(const SpacingField &spacing, Vec2 a, Vec2 b, double rhoA, double rhoB);

} // namespace forefront
