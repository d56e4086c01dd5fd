#include "core/engine/pipeline/target_elements.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/pipeline/element_limit.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/scaled_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace forefront {
namespace {

constexpr int kMaxMeshes = 14;
constexpr int kMaxClose = 3;         ///< meshes from the first that reaches the target: counts may jump past it
constexpr double kAimed = 0.02;      ///< relative deviation at which the search ends
constexpr double kMaxStep = 1.5;     ///< of the logarithm of the factor
constexpr double kFarthest = 14.0;   ///< logarithm of the largest factor
constexpr double kFinestStep = 2e-4; ///< of the logarithm: the digits of the factor end here
constexpr double kStillStep = 0.2;   ///< a step of the logarithm that should change the number of elements

constexpr int kFactorDigits = 4;

/// A factor that was tried.
struct TargetTrial {
    double x = 0.0; ///< logarithm of the factor
    double y = 0.0; ///< logarithm of the number of elements over the target
    bool known = false;
};

/// Proposes factors from the numbers of elements that earlier ones led to. The number falls as the factor grows.
class FactorSearch {
  public:
    explicit FactorSearch(double x) : x_(x) {}

    double next() const { return x_; }
    /// Takes note of a trial: `x` and `y` as in TargetTrial. Returns false if no further factor can help.
    bool add(double x, double y) {
        const TargetTrial earlier = std::exchange(last_, {x, y, true});
        (y > 0.0 ? above_ : below_) = last_;
        ++trials_;
        if (below_.known && above_.known) {
            return narrow();
        }
        if (earlier.known && earlier.y == y && std::abs(earlier.x - x) > kStillStep) {
            return false; // limits hold the sizes
        }
        double slope = -2.0; // of a uniform spacing
        if (earlier.known && std::abs(earlier.x - x) > 0.01) {
            slope = std::clamp((earlier.y - y) / (earlier.x - x), -4.0, -0.5);
        }
        x_ = std::clamp(x + std::clamp(-y / slope, -kMaxStep, kMaxStep), -kFarthest, kFarthest);
        return x_ != x;
    }

  private:
    /// Proposes a factor between one that is too small and one that is too large.
    bool narrow() {
        const double low = above_.x, high = below_.x;
        if (!(high - low > kFinestStep)) {
            return false;
        }
        const double secant = low + (high - low) * above_.y / (above_.y - below_.y);
        const double margin = 0.1 * (high - low);
        x_ = trials_ % 3 == 0 ? 0.5 * (low + high) : std::clamp(secant, low + margin, high - margin);
        return true;
    }

    double x_;
    TargetTrial above_, below_; ///< the last one with too many elements, and with too few
    TargetTrial last_;
    int trials_ = 0;
};

/// Returns the estimated number of elements of a job.
Result<double> estimateOf(const MeshingJob &job, std::uint64_t target, const Progress &progress) {
    const Result<PreparedJob> prepared = planMesh(job, progress, static_cast<double>(target));
    if (!prepared) {
        return prepared.faults();
    }
    return std::max(1.0, prepared->requestedElements);
}

/// The meshes of a search, of which the nearest to the target counts.
class TargetMeshes {
  public:
    TargetMeshes(const std::function<MeshingJob(double factor)> &jobWith, std::uint64_t target)
        : jobWith_(jobWith), target_(static_cast<double>(target)) {}

    /// Makes the mesh with a factor and returns the logarithm of its number of elements over the target; a large number
    /// if there are more than the options allow.
    Result<double> mesh(double factor, const Progress &progress) {
        MeshingJob job = jobWith_(factor);
        job.shared = nullptr; // the field of other sizes
        job.options.verify = false;
        const Result<MeshingOutcome> outcome = meshDomain(job, progress);
        ++best_.meshes;
        if (!outcome) {
            refused_ = outcome.faults();
            return hasCode(refused_, "too-many-elements") ? Result<double>(kFarTooMany) : refused_;
        }
        const std::size_t elements = MeshView(outcome->mesh).elementCount();
        const double y = std::log(static_cast<double>(std::max<std::size_t>(elements, 1)) / target_);
        if (std::abs(y) < nearest_) {
            nearest_ = std::abs(y);
            best_.factor = factor;
            best_.elements = elements;
        }
        return y;
    }
    /// Returns true if a mesh so far reaches the target.
    bool reached() const { return nearest_ <= std::log1p(kTargetTolerance); }
    /// Returns the sizes of the nearest mesh; faults if none was made.
    Result<TargetSizes> best() const {
        return best_.elements == 0 ? Result<TargetSizes>(refused_) : Result<TargetSizes>(best_);
    }

  private:
    static constexpr double kFarTooMany = 4.0;

    const std::function<MeshingJob(double factor)> &jobWith_;
    double target_;
    TargetSizes best_;
    double nearest_ = std::numeric_limits<double>::infinity();
    Diagnostics refused_;
};

} // namespace

double estimatedFactor(double estimate, std::uint64_t target) {
    return roundedTo(std::sqrt(estimate / static_cast<double>(target)), kFactorDigits);
}

Result<TargetSizes> sizesForElements(const std::function<MeshingJob(double factor)> &jobWith, std::uint64_t target,
                                     const Progress &progress) {
    const MeshingJob given = jobWith(1.0);
    if (const std::uint64_t limit = limitOf(given.options); target == 0 || target > limit) {
        return error("bad-target",
                     "invalid number of elements " + std::to_string(target) + "; expected 1 to " +
                         std::to_string(limit),
                     target == 0 ? "" : "raise the maximum number of elements");
    }
    const Result<double> estimate = estimateOf(given, target, progress);
    if (!estimate) {
        return estimate.faults();
    }
    FactorSearch search(std::clamp(0.5 * std::log(*estimate / static_cast<double>(target)), -kFarthest, kFarthest));
    TargetMeshes meshes(jobWith, target);
    int close = 0; // meshes since the target was reached
    for (int made = 0; made < kMaxMeshes; ++made) {
        const double factor = roundedTo(std::exp(search.next()), kFactorDigits);
        const Result<double> y = meshes.mesh(factor, progress);
        if (!y) {
            return y.faults();
        }
        close += meshes.reached() ? 1 : 0;
        if (std::abs(*y) <= kAimed || close >= kMaxClose || !search.add(std::log(factor), *y)) {
            break;
        }
    }
    return meshes.best();
}

Diagnostics missedTarget(const TargetSizes &sizes, std::uint64_t target, const MeshingJob &job) {
    if (sizes.reaches(target)) {
        return {};
    }
    std::string held = unscaledSizes(job.spacing);
    const auto add = [&held](const char *what) { held += (held.empty() ? "" : ", ") + std::string(what); };
    if (job.options.keepBoundary) {
        add("the kept segments");
    }
    if (!job.domain.curves.empty() && sizes.elements > target) {
        add("the curve tolerance (a larger one: --curve-tolerance)");
    }
    if (held.empty()) {
        add("the outline");
    }
    Diagnostic warning;
    warning.severity = Severity::Warning;
    warning.code = "missed-target";
    warning.message = "the sizes lead to " + std::to_string(sizes.elements) + " elements at best; expected about " +
                      std::to_string(target);
    warning.advice = "what holds the sizes: " + held;
    return {warning};
}

} // namespace forefront
