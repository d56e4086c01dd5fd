#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/improve/cleanup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace forefront {

/// Measures how near a triangle comes to a goal: 1 if it just meets the goal, negative if inverted. The lower of α/α*
/// and sin²θ/sin²θ*, where θ is the minimum angle; computed from squared sides, without roots.
class ShapeMeasure {
  public:
    explicit ShapeMeasure(const ShapeGoal &goal)
        : alphaFactor_(2.0 * std::numbers::sqrt3 / goal.alpha), sineFactor_(1.0 / square(sine(goal.angle))),
          surelyGood_(std::max(goal.alpha, needleAlpha(goal.angle))) {}

    double operator()(Vec2 a, Vec2 b, Vec2 c) const { return of(b - a, c - a, lengthSquared(c - b)); }

    /// Returns the measure of the triangle with sides u and v at a node and the square of the third side.
    double of(Vec2 u, Vec2 v, double third) const {
        const double twiceArea = cross(u, v);
        const double uu = lengthSquared(u), vv = lengthSquared(v);
        if (!(twiceArea > 0.0)) {
            return uu + vv + third > 0.0 ? alphaFactor_ * twiceArea / (uu + vv + third) : 0.0;
        }
        // The sine of the minimum angle is twice the area divided by the product of the two longer sides.
        const double shortest = std::min({uu, vv, third});
        return twiceArea *
               std::min(alphaFactor_ / (uu + vv + third), sineFactor_ * twiceArea * shortest / (uu * vv * third));
    }

    /// Returns the same number, bit for bit, if it is positive, else any that is not. `third` must be positive. Has no
    /// branches, so that g++ and clang make vector instructions of a loop over triangles.
    double ifPositive(Vec2 u, Vec2 v, double third) const {
        const double twiceArea = cross(u, v);
        const double uu = lengthSquared(u), vv = lengthSquared(v);
        const double positiveArea = twiceArea > 0.0 ? twiceArea : 0.0;
        const double shorter = vv < uu ? vv : uu, shortest = third < shorter ? third : shorter;
        const double byAlpha = alphaFactor_ / (uu + vv + third);
        const double byAngle = sineFactor_ * positiveArea * shortest / (uu * vv * third); // NaN if a side has no length
        return twiceArea * (byAngle < byAlpha ? byAngle : byAlpha);
    }

    /// Returns the α above which every element meets the goal.
    double surelyGood() const { return surelyGood_; }

  private:
    static double square(double s) { return s * s; }
    static double sine(double degrees) { return std::sin(degrees * std::numbers::pi / 180.0); }
    /// Returns the maximum α of triangles with minimum angle θ, which the isosceles triangle with θ at the apex
    /// attains.
    static double needleAlpha(double degrees) {
        return std::numbers::sqrt3 * sine(degrees) / (2.0 - sine(90.0 - degrees));
    }

    double alphaFactor_, sineFactor_, surelyGood_;
};

} // namespace forefront
