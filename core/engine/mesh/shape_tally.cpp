#include "core/engine/mesh/shape_tally.hpp"

#include "core/engine/geometry/flat.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace forefront {

void ShapeTally::CotangentRange::add(Vec2 a, Vec2 b, Vec2 c) {
    const double twiceArea = cross(b - a, c - a);
    if (!(twiceArea > 0.0)) {
        flat_ = true;
        return;
    }
    const double atA = dot(b - a, c - a), atB = dot(a - b, c - b), atC = dot(a - c, b - c);
    maxCot_ = std::max(maxCot_, std::max({atA, atB, atC}) / twiceArea);
    minCot_ = std::min(minCot_, std::min({atA, atB, atC}) / twiceArea);
}

void ShapeTally::CotangentRange::addAt(Vec2 before, Vec2 tip, Vec2 after) {
    const double turn = cross(after - tip, before - tip);
    if (!(turn > 0.0)) {
        flat_ = true;
        return;
    }
    const double cotangent = dot(after - tip, before - tip) / turn;
    maxCot_ = std::max(maxCot_, cotangent);
    minCot_ = std::min(minCot_, cotangent);
}

namespace {

double scaledJacobianOf(Vec2 a, Vec2 b, Vec2 c) {
    PlacedCell cell;
    cell.nodes = {a, b, c};
    return scaledJacobian(cell);
}

double degreesOfCotangent(double cotangent) {
    return std::atan2(1.0, cotangent) * 180.0 / std::numbers::pi;
}

} // namespace

double ShapeTally::CotangentRange::min() const {
    return flat_ ? 0.0 : degreesOfCotangent(maxCot_);
}

double ShapeTally::CotangentRange::max() const {
    return flat_ ? 180.0 : degreesOfCotangent(minCot_);
}

double ShapeTally::CotangentRange::sineOfMin() const {
    return flat_                                                 ? 0.0
           : maxCot_ == -std::numeric_limits<double>::infinity() ? std::numeric_limits<double>::infinity()
                                                                 : 1.0 / std::sqrt(1.0 + maxCot_ * maxCot_);
}

inline void ShapeTally::addAlpha(double alpha) {
    sum_ += alpha;
    if (alpha < minAlpha_) {
        minAlpha_ = alpha;
        worst_ = ElementId{static_cast<std::uint32_t>(count_)};
    }
    allPositive_ = allPositive_ && alpha > 0.0;
    if (alpha > 0.0) {
        product_.multiply(alpha);
    }
    const double bin = std::clamp(alpha, 0.0, 1.0) * static_cast<double>(kHistogramBins);
    ++histogram_[std::min(static_cast<std::size_t>(bin), kHistogramBins - 1)];
    ++count_;
}

void ShapeTally::add(Vec2 a, Vec2 b, Vec2 c) {
    const double alpha = shapeFactor(a, b, c);
    twiceArea_ += cross(b - a, c - a);
    angles_.add(a, b, c);
    if (!(alpha > 0.0)) [[unlikely]] { // the angles know of those that are positive
        minScaledJacobian_ = std::min(minScaledJacobian_, scaledJacobianOf(a, b, c));
    }
    flat_ += isFlat(a, b, c) ? 1 : 0;
    addAlpha(alpha);
}

void ShapeTally::add(const PlacedCell &cell) {
    twiceArea_ += twiceArea(cell);
    bool flat = false;
    for (std::size_t k = 0; k < cell.corners().size(); ++k) {
        cornerAngles_.addAt(cell.cornerBefore(k), cell.nodes[k], cell.cornerAfter(k));
        flat = flat || isFlat(cell.cornerBefore(k), cell.nodes[k], cell.cornerAfter(k));
    }
    minScaledJacobian_ = std::min(minScaledJacobian_, scaledJacobian(cell));
    flat_ += flat ? 1 : 0;
    ++others_[static_cast<std::size_t>(cell.kind)];
    addAlpha(shapeFactor(cell));
}

void ShapeTally::into(MeshQuality &quality) const {
    if (count_ == 0) {
        return;
    }
    const auto count = static_cast<double>(count_);
    quality.elements = count_;
    quality.kinds = others_;
    quality.kinds[static_cast<std::size_t>(CellKind::Triangle3)] =
        count_ - std::accumulate(others_.begin(), others_.end(), std::size_t{0});
    quality.area = 0.5 * twiceArea_;
    quality.alphaMean = sum_ / count;
    quality.alphaGeometricMean = allPositive_ ? std::exp(product_.logarithm() / count) : 0.0;
    quality.alphaMin = minAlpha_;
    quality.minAngle = std::min(angles_.min(), cornerAngles_.min());
    quality.maxAngle = std::max(angles_.max(), cornerAngles_.max());
    constexpr double kEquilateralSine = 0.5 * std::numbers::sqrt3;
    quality.minScaledJacobian = std::min(minScaledJacobian_, angles_.sineOfMin() / kEquilateralSine);
    quality.worst = worst_;
    quality.flat = flat_;
    quality.alphaHistogram = histogram_;
}

} // namespace forefront
