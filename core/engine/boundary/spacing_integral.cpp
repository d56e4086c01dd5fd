#include "core/engine/boundary/spacing_integral.hpp"

#include "core/engine/domain/chord_limit.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

constexpr double kMinStep = 0x1p-48; // finer fractions would round to the same number
constexpr double kMinFirstStep = 0x1p-10;

bool isValid(double density) {
    return density > 0.0 && std::isfinite(density);
}

struct StraightPath {
    Vec2 a, b;
    double span = 0.0;

    Vec2 at(double fraction) const { return lerp(a, b, fraction); }
    double density(double, double rho) const { return span / rho; }
};

} // namespace

double CurvePath::density(double fraction, double rho) const {
    constexpr double kLeast = 1e-6; // a curve may stand still at a point
    const double t = std::lerp(t0, t1, fraction);
    const Vec2 first = curve->derivative(t);
    const double speed = length(first), range = std::fabs(t1 - t0);
    const double asked = range * speed / rho;
    if (!(asked >= 0.0 && rho > 0.0)) {
        return -1.0;
    }
    const double curvature = std::fabs(cross(first, curve->secondDerivative(t))) / (speed * speed * speed);
    const double needed = curvature > 0.0 ? range * speed / ChordLimit::longest(curvature, tolerance) : 0.0;
    return std::max({kLeast, asked, std::isfinite(needed) ? needed : 0.0});
}

bool CurvePath::allows(double from, double to) const {
    constexpr double kSlack = 1.1; // the integral is accurate to a few percent on one piece
    const double a = std::lerp(t0, t1, from), b = std::lerp(t0, t1, to);
    const double deviation = curve->deviation(a, b), turning = curve->turning(a, b);
    using Limit = ChordLimit;
    return (deviation <= tolerance && turning <= kSlack * Limit::kMaxTurn) ||
           (deviation <= kSlack * Limit::kTiny * tolerance && turning <= kSlack * Limit::kMaxTinyTurn) ||
           deviation <= Limit::kCusp * tolerance;
}

void SpacingIntegral::append(double t, double density) {
    const Sample &last = samples_.back();
    samples_.push_back({t, density, last.integral + 0.5 * (last.density + density) * (t - last.t)});
}

SpacingIntegral::Outcome SpacingIntegral::fail(Vec2 place) {
    badPlace_ = place;
    return Outcome::BadSpacing;
}

SpacingIntegral::Outcome SpacingIntegral::integrate(const SpacingField &spacing, Vec2 a, Vec2 b, double rhoA,
                                                    double rhoB, double longest, double limit,
                                                    const Progress &progress) {
    const StraightPath path{a, b, distance(a, b)};
    return follow(spacing, path, path.density(0.0, rhoA), path.density(1.0, rhoB),
                  std::max(longest / path.span, kMinFirstStep), limit, progress);
}

SpacingIntegral::Outcome SpacingIntegral::integrate(const SpacingField &spacing, const CurvePath &path, double longest,
                                                    double limit, const Progress &progress) {
    constexpr double kFirstStep = 1.0 / 16.0; // the speed and the bend of a curve vary along it
    const double span = path.curve->length(path.t0, path.t1);
    return follow(spacing, path, path.density(0.0, spacing.at(path.at(0.0))),
                  path.density(1.0, spacing.at(path.at(1.0))), std::clamp(longest / span, kMinFirstStep, kFirstStep),
                  limit, progress);
}

template <class Path>
SpacingIntegral::Outcome SpacingIntegral::follow(const SpacingField &spacing, const Path &path, double densityA,
                                                 double densityB, double longestStep, double limit,
                                                 const Progress &progress) {
    constexpr std::size_t kSamplesPerCheck = 1U << 14;
    samples_.clear();
    stack_.clear();
    samples_.push_back({0.0, densityA, 0.0});
    if (!isValid(densityA) || !isValid(densityB)) {
        return fail(path.at(isValid(densityA) ? 1.0 : 0.0));
    }
    stack_.push_back({0.0, 1.0, densityA, densityB});
    while (!stack_.empty()) {
        const Interval interval = stack_.back();
        stack_.pop_back();
        const double middle = 0.5 * (interval.t0 + interval.t1), step = interval.t1 - interval.t0;
        const Vec2 place = path.at(middle);
        const double density = path.density(middle, spacing.at(place));
        if (!isValid(density)) {
            return fail(place);
        }
        const double maximum = std::max({interval.density0, density, interval.density1});
        const double minimum = std::min({interval.density0, density, interval.density1});
        const double pieces = maximum * step;
        if ((pieces > 1.0 || step > longestStep || (pieces > 0.1 && maximum > 2.0 * minimum)) && step > kMinStep) {
            stack_.push_back({middle, interval.t1, density, interval.density1});
            stack_.push_back({interval.t0, middle, interval.density0, density});
            continue;
        }
        append(middle, density);
        append(interval.t1, interval.density1);
        if (total() > limit) {
            return Outcome::TooMany;
        }
        if (samples_.size() % kSamplesPerCheck == 1 && progress.cancelled()) {
            return Outcome::Cancelled;
        }
    }
    return Outcome::Done;
}

double SpacingIntegral::pieces() const {
    // k and k + 1 pieces are off by the same factor where N = sqrt(k (k + 1)).
    const double below = std::floor(total());
    return std::max(1.0, total() > std::sqrt(below * (below + 1.0)) ? below + 1.0 : below);
}

void SpacingIntegral::cut(std::uint32_t count, std::vector<double> &fractions) const {
    fractions.clear();
    std::size_t i = 0;
    for (std::uint32_t k = 1; k < count; ++k) {
        const double target = total() * k / count;
        while (i + 2 < samples_.size() && samples_[i + 1].integral < target) {
            ++i;
        }
        // Density d0 + slope·u within the interval: d0 u + slope u²/2 = rest, solved without cancellation.
        const Sample &from = samples_[i], &to = samples_[i + 1];
        const double rest = std::max(0.0, target - from.integral);
        const double slope = (to.density - from.density) / (to.t - from.t);
        const double root = std::sqrt(std::max(0.0, from.density * from.density + 2.0 * slope * rest));
        fractions.push_back(std::min(to.t, from.t + 2.0 * rest / (from.density + root)));
    }
}

double roughSpacingIntegral(const SpacingField &spacing, Vec2 a, Vec2 b, double rhoA, double rhoB) {
    constexpr int kMaxSamples = 4096;
    struct Interval {
        double t0, t1, density0, density1;
    };
    const double span = distance(a, b);
    std::vector<Interval> stack{{0.0, 1.0, span / rhoA, span / rhoB}};
    double sum = 0.0;
    for (int samples = 0; !stack.empty(); ++samples) {
        const Interval interval = stack.back();
        stack.pop_back();
        const double middle = 0.5 * (interval.t0 + interval.t1), step = interval.t1 - interval.t0;
        const double density = span / spacing.at(lerp(a, b, middle));
        const double maximum = std::max({interval.density0, density, interval.density1});
        const double minimum = std::min({interval.density0, density, interval.density1});
        if (maximum > 2.0 * minimum && maximum * step > 1.0 && step > kMinStep && samples < kMaxSamples) {
            stack.push_back({middle, interval.t1, density, interval.density1});
            stack.push_back({interval.t0, middle, interval.density0, density});
        } else {
            sum += step * (interval.density0 + 4.0 * density + interval.density1) / 6.0; // Simpson's rule
        }
    }
    return sum;
}

} // namespace forefront
