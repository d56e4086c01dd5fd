#pragma once

#include "core/base/vec2.hpp"

#include <cstdint>
#include <span>

namespace forefront {

/// Adds doubles with the error of each addition carried along (Neumaier's variant of Kahan's summation).
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

/// Area of the closed polygon, positive when counter-clockwise. Summed from the first node as local origin, so an
/// offset of the whole polygon costs no digits.
double signedArea(std::span<const Vec2> polygon);

/// Length of the closed polygon.
double perimeter(std::span<const Vec2> polygon);

enum class PointPlace : std::uint8_t { Outside, OnBoundary, Inside };

/// Where p lies relative to a closed polygon by the even-odd rule (exact; the polygon may be of either orientation and
/// may cross itself).
PointPlace locate(std::span<const Vec2> polygon, Vec2 p);

/// Distance from p to the closed segment ab.
double distanceToSegment(Vec2 a, Vec2 b, Vec2 p);

} // namespace forefront
