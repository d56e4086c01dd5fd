#pragma once

#include "core/engine/base/vec2.hpp"

#include <cstdint>
#include <span>

namespace forefront {

/// A compensated sum of doubles (Neumaier's variant of Kahan's summation).
class CompensatedSum {
  public:
    void add(double value) {
        const double sum = sum_ + value;
        rest_ += std::fabs(sum_) >= std::fabs(value) ? (sum_ - sum) + value : (value - sum) + sum_;
        sum_ = sum;
    }
    double value() const { return sum_ + rest_; }

  private:
    double sum_ = 0.0;
    double rest_ = 0.0;
};

/// Returns the area of the closed polygon, positive if counter-clockwise. Coordinates are taken relative to the first
/// node, so a polygon far from the origin loses no digits.
double signedArea(std::span<const Vec2> polygon);

/// Returns the length of the closed polygon.
double perimeter(std::span<const Vec2> polygon);

enum class PointPlace : std::uint8_t { Outside, OnBoundary, Inside };

/// Returns where p lies relative to a closed polygon by the even-odd rule. Exact; the polygon may have either
/// orientation and may cross itself.
PointPlace locate(std::span<const Vec2> polygon, Vec2 p);

/// Returns the distance from p to the closed segment ab.
double distanceToSegment(Vec2 a, Vec2 b, Vec2 p);

} // namespace forefront
