#include "core/engine/mesh/shape_tally.hpp"

#include "core/engine/geometry/flat.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace forefront {

void ShapeTally::AngleRange::add(Vec2 a, Vec2 b, Vec2 c) {
    const double twiceArea = cross(b - a, c - a);
    if (!(twiceArea > 0.0)) {
        flat_ = true;
        return;
    }
    const double atA = dot(b - a, c - a), atB = dot(a - b, c - b), atC = dot(a - c, b - c);
    maxCot_ = std::max(maxCot_, std::max({atA, atB, atC}) / twiceArea);
    minCot_ = std::min(minCot_, std::min({atA, atB, atC}) / twiceArea);
}

namespace {

double degreesOfCotangent(double cotangent) {
    return std::atan2(1.0, cotangent) * 180.0 / std::numbers::pi;
}

} // namespace

double ShapeTally::AngleRange::min() const {
    return flat_ ? 0.0 : degreesOfCotangent(maxCot_);
}

double ShapeTally::AngleRange::max() const {
    return flat_ ? 180.0 : degreesOfCotangent(minCot_);
}

void ShapeTally::add(Vec2 a, Vec2 b, Vec2 c) {
    const double alpha = shapeFactor(a, b, c);
    sum_ += alpha;
    twiceArea_ += cross(b - a, c - a);
    angles_.add(a, b, c);
    if (alpha < minAlpha_) {
        minAlpha_ = alpha;
        worst_ = ElementId{static_cast<std::uint32_t>(count_)};
    }
    allPositive_ = allPositive_ && alpha > 0.0;
    flat_ += isFlat(a, b, c) ? 1 : 0;
    if (alpha > 0.0) {
        product_.multiply(alpha);
    }
    const double bin = std::clamp(alpha, 0.0, 1.0) * static_cast<double>(kHistogramBins);
    ++histogram_[std::min(static_cast<std::size_t>(bin), kHistogramBins - 1)];
    ++count_;
}

void ShapeTally::into(MeshQuality &quality) const {
    if (count_ == 0) {
        return;
    }
    const auto count = static_cast<double>(count_);
    quality.elements = count_;
    quality.area = 0.5 * twiceArea_;
    quality.alphaMean = sum_ / count;
    quality.alphaGeometricMean = allPositive_ ? std::exp(product_.logarithm() / count) : 0.0;
    quality.alphaMin = minAlpha_;
    quality.minAngle = angles_.min();
    quality.maxAngle = angles_.max();
    quality.worst = worst_;
    quality.flat = flat_;
    quality.alphaHistogram = histogram_;
}

} // namespace forefront
