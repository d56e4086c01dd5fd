#include "core/drawing/sketch/part_solver.hpp"

#include "core/drawing/sketch/normal_equations.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace forefront {
namespace {

double largest(const SketchVector &vector) {
    return vector.size() > 0 ? vector.lpNorm<forefront_eigen::Infinity>() : 0.0;
}

/// Levenberg-Marquardt for one part: the damping rises while steps fail and falls while they succeed.
class Satisfier {
  public:
    Satisfier(ScaledPart &part, const SatisfyOptions &options)
        : part_(part), options_(options),
          weights_(options.weights != nullptr ? *options.weights : SketchVector(SketchVector::Ones(part.x.size()))),
          residuals_(residualsAt(part.x)) {}

    bool run() {
        for (int k = 0; k < options_.iterations; ++k) {
            const double worst = largest(residuals_);
            if (!(worst > kSketchTolerance)) {
                polish(k > 0 && worst > 0.0);
                return std::isfinite(worst);
            }
            normal_.set(part_.slopes(part_.x), weights_);
            if (!step()) {
                constexpr double kRounding = 100.0; // no step reduces what is left by rounding
                return worst < kRounding * kSketchTolerance;
            }
        }
        return largest(residuals_) <= kSketchTolerance;
    }

  private:
    SketchVector residualsAt(const SketchVector &place) const {
        SketchVector residuals = part_.residuals(place);
        if (options_.residuals != nullptr) {
            residuals -= *options_.residuals;
        }
        return residuals;
    }

    /// Takes one step more, which leaves only what rounding does. A place that was right from the start stays.
    void polish(bool wanted) {
        if (wanted) {
            normal_.set(part_.slopes(part_.x), weights_);
            step();
        }
    }

    /// Takes one step that reduces the residuals. Returns false if there is none.
    bool step() {
        constexpr double kMost = 1e4, kLeast = 1e-12, kFirst = 1e-6;
        for (int attempt = 0; attempt < 14 && damping_ <= kMost; ++attempt) {
            if (!normal_.factorise(damping_)) {
                damping_ *= 10.0;
                continue;
            }
            const SketchVector step = normal_.stepOf(normal_.solve(-residuals_));
            if (step.allFinite() && shorten(step)) {
                damping_ = std::max(0.1 * damping_, kLeast);
                return true;
            }
            damping_ = damping_ < kFirst ? kFirst : 10.0 * damping_;
        }
        return false;
    }

    /// Takes a part of a step that reduces the residuals and keeps the guarded corners.
    bool shorten(const SketchVector &step) {
        const double size = largest(step);
        double share =
            std::min(size > options_.longestStep ? options_.longestStep / size : 1.0, part_.allowedShare(step));
        const int cuts = part_.guarded() ? 6 : 3;
        for (int k = 0; k < cuts; ++k, share *= 0.4) {
            const SketchVector place = part_.x + share * step;
            if (!part_.keepsCorners(place)) {
                continue;
            }
            SketchVector residuals = residualsAt(place);
            constexpr double kDecrease = 1e-4;
            if (residuals.allFinite() && residuals.norm() < (1.0 - kDecrease * share) * residuals_.norm()) {
                part_.x = place;
                residuals_ = std::move(residuals);
                return true;
            }
        }
        return false;
    }

    ScaledPart &part_;
    const SatisfyOptions &options_;
    SketchVector weights_, residuals_;
    NormalEquations normal_;
    double damping_ = kSketchTolerance;
};

/// Sequential quadratic steps towards the nearest solution, with a line search: for a rod pulled from more than twice
/// its length, full steps overshoot for ever.
class Projector {
  public:
    Projector(ScaledPart &part, const SketchVector &reference, const SketchVector &weights)
        : part_(part), reference_(reference), weights_(weights), residuals_(part.residuals(part.x)) {}

    void run() {
        constexpr int kIterations = 12;
        for (int k = 0; k < kIterations && step(); ++k) {
        }
    }

    double worst() const { return largest(residuals_); }

  private:
    double merit(const SketchVector &place, const SketchVector &residuals) const {
        double distance = 0.0;
        for (int k = 0; k < place.size(); ++k) {
            const double gap = place[k] - reference_[k];
            distance += gap != 0.0 ? weights_[k] * (gap * gap) : 0.0; // where the weight is infinite, there is no gap
        }
        return 0.5 * distance + penalty_ * residuals.lpNorm<1>();
    }

    bool step() {
        normal_.set(part_.slopes(part_.x), weights_);
        double damping = 1e-10;
        while (!normal_.factorise(damping)) {
            damping *= 100.0;
            if (damping > 1.0) {
                return false;
            }
        }
        const SketchVector gap = reference_ - part_.x;
        const SketchVector lambda = normal_.solve(-(residuals_ + normal_.apply(gap)));
        const SketchVector step = gap + normal_.stepOf(lambda);
        constexpr double kClose = 1e-6, kSatisfied = 1e-7, kLongest = 0.3;
        const double size = largest(step);
        if (!step.allFinite() || (size < kClose && largest(residuals_) < kSatisfied)) {
            return false;
        }
        penalty_ = std::max(penalty_, 1.5 * largest(lambda));
        return shorten(step, size > kLongest ? kLongest / size : 1.0);
    }

    bool shorten(const SketchVector &step, double share) {
        const double now = merit(part_.x, residuals_);
        for (int k = 0; k < 10; ++k, share *= 0.5) {
            const SketchVector place = part_.x + share * step;
            SketchVector residuals = part_.residuals(place);
            if (merit(place, residuals) < now) {
                part_.x = place;
                residuals_ = std::move(residuals);
                return true;
            }
        }
        return false;
    }

    ScaledPart &part_;
    const SketchVector &reference_, &weights_;
    SketchVector residuals_;
    NormalEquations normal_;
    double penalty_ = 10.0;
};

} // namespace

bool satisfy(ScaledPart &part, const SatisfyOptions &options) {
    const SketchVector start = part.x;
    if (Satisfier(part, options).run() && part.sound()) {
        return true;
    }
    part.x = start;
    return false;
}

void approach(ScaledPart &part) {
    Satisfier(part, {}).run();
}

bool follow(ScaledPart &part, int steps, const SketchVector *weights) {
    const SketchVector start = part.x, residuals = part.residuals(start);
    for (int k = 1; k <= steps; ++k) {
        const SketchVector remaining = (1.0 - static_cast<double>(k) / steps) * residuals;
        constexpr double kLongest = 0.1;
        if (!satisfy(part,
                     {.residuals = k < steps ? &remaining : nullptr, .weights = weights, .longestStep = kLongest})) {
            part.x = start;
            return false;
        }
    }
    return true;
}

bool project(ScaledPart &part, const SketchVector &reference, const SketchVector &weights) {
    const SketchVector start = part.x;
    Projector(part, reference, weights).run();
    if (satisfy(part)) {
        return true;
    }
    part.x = start;
    return false;
}

bool projectFirm(ScaledPart &part, const SketchVector &reference, const std::vector<bool> &firm) {
    const SketchVector start = part.x;
    SketchVector weights = SketchVector::Ones(start.size());
    for (int k = 0; k < start.size(); ++k) {
        if (firm[static_cast<std::size_t>(k)]) {
            part.x[k] = reference[k];
            weights[k] = INFINITY;
        }
    }
    Projector projector(part, reference, weights);
    projector.run();
    constexpr double kNear = 1e-2; // residual from which few steps lead to a solution, if there is one
    constexpr int kSteps = 8;
    if (projector.worst() < kNear && satisfy(part, {.weights = &weights, .iterations = kSteps})) {
        return true;
    }
    part.x = start;
    return false;
}

} // namespace forefront
