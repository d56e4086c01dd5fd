#include "core/boundary/spacing_integral.hpp"

namespace forefront {

namespace {

constexpr double kMinStep = 0x1p-48; // finer fractions would be equal
constexpr double kMinFirstStep = 0x1p-10;

bool isValid(double density) {
    return density > 0.0 && std::isfinite(density);
}

} // namespace

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
    constexpr std::size_t kSamplesPerCheck = 1U << 14;
    const double span = distance(a, b);
    samples_.clear();
    stack_.clear();
    samples_.push_back({0.0, span / rhoA, 0.0});
    if (!isValid(span / rhoA) || !isValid(span / rhoB)) {
        return fail(isValid(span / rhoA) ? b : a);
    }
    const double longestStep = std::max(longest / span, kMinFirstStep);
    stack_.push_back({0.0, 1.0, span / rhoA, span / rhoB});
    while (!stack_.empty()) {
        const Interval interval = stack_.back();
        stack_.pop_back();
        const double middle = 0.5 * (interval.t0 + interval.t1), step = interval.t1 - interval.t0;
        const Vec2 place = lerp(a, b, middle);
        const double density = span / spacing.at(place);
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
