#include "core/engine/adapt/error_spacing.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/paced_progress.hpp"
#include "core/engine/mesh/topology.hpp"
#include "core/engine/spacing/parts/background/limit_gradation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <queue>

namespace forefront {

namespace {

constexpr double kMaxRefinement = 1.0 / 6.0;
constexpr double kMaxCoarsening = 3.0;

std::vector<double> areasOf(const TriMesh &mesh) {
    std::vector<double> areas;
    areas.reserve(mesh.elements.size());
    for (const Element &nodes : mesh.elements) {
        const Vec2 a = mesh.nodes[index(nodes[0])];
        areas.push_back(0.5 * cross(mesh.nodes[index(nodes[1])] - a, mesh.nodes[index(nodes[2])] - a));
    }
    return areas;
}

/// Returns the side of the equilateral triangle of this area.
double sizeOf(double area) {
    return std::sqrt(4.0 / std::numbers::sqrt3 * area);
}

/// Computes the spacing from an error per element, see elementSpacing().
class SpacingLaw {
  public:
    SpacingLaw(const TriMesh &mesh, const ErrorEstimate &estimate, const AdaptTarget &target)
        : sizes_(areasOf(mesh)), errors_(estimate.elements), target_(target) {
        for (double &size : sizes_) {
            size = sizeOf(size);
        }
    }

    double spacing(std::size_t e, double elementError) const {
        const double h = sizes_[e];
        const double factor = errors_[e] > 0.0 ? std::sqrt(elementError / errors_[e]) : kMaxCoarsening;
        const double size = h * std::clamp(factor, kMaxRefinement, kMaxCoarsening);
        return std::min(std::max(size, target_.sizeMin), target_.sizeMax);
    }

    /// Returns the error per element for which the total meets the target; std::nullopt when cancelled. The square of
    /// the total is the sum of (h_new/h)²·e² over the old elements and grows with it, so bisection of its logarithm
    /// finds it. The minimum size is ignored: where it applies, no refinement of the other elements could make up for
    /// it.
    std::optional<double> solve(double wantedTotal, const Progress &progress) const {
        std::vector<double> maxShares(sizes_.size()); // share of each element at its maximum size
        for (std::size_t e = 0; e < maxShares.size(); ++e) {
            const double ratio = std::min(kMaxCoarsening, target_.sizeMax / sizes_[e]) * errors_[e];
            maxShares[e] = ratio * ratio;
        }
        double low = std::log(wantedTotal) - 60.0, high = std::log(wantedTotal) + 10.0;
        constexpr int kSteps = 60;
        for (int i = 0; i < kSteps; ++i) {
            if (progress.cancelled()) {
                return std::nullopt;
            }
            progress("choosing the node spacing", static_cast<double>(i) / kSteps);
            const double middle = 0.5 * (low + high), elementError = std::exp(middle);
            double sum = 0.0;
            for (std::size_t e = 0; e < maxShares.size(); ++e) {
                sum += std::min(elementError * errors_[e], maxShares[e]);
            }
            (sum > wantedTotal * wantedTotal ? high : low) = middle;
        }
        return std::exp(low);
    }

  private:
    std::vector<double> sizes_; ///< sides of equilateral triangles of the elements' areas
    const std::vector<double> &errors_;
    const AdaptTarget &target_;
};

} // namespace

Result<std::vector<double>> elementSpacing(const TriMesh &mesh, const ErrorEstimate &estimate,
                                           const AdaptTarget &target, const Progress &progress) {
    const SpacingLaw law(mesh, estimate, target);
    const double total = target.error * std::hypot(estimate.norm, estimate.total);
    const std::optional<double> elementError = total > 0.0 ? law.solve(total, progress) : 1.0;
    if (!elementError) {
        return cancelled("choosing the node spacing");
    }
    std::vector<double> spacing(mesh.elements.size());
    for (std::size_t e = 0; e < spacing.size(); ++e) {
        spacing[e] = law.spacing(e, *elementError);
    }
    return spacing;
}

std::vector<double> nodalSpacing(const TriMesh &mesh, std::span<const double> elementSpacing) {
    const std::vector<double> areas = areasOf(mesh);
    std::vector<double> area(mesh.nodes.size(), 0.0), density(mesh.nodes.size(), 0.0);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        for (const NodeId node : mesh.elements[e]) {
            area[index(node)] += areas[e];
            density[index(node)] += areas[e] / (elementSpacing[e] * elementSpacing[e]);
        }
    }
    std::vector<double> spacing(mesh.nodes.size(), 1.0); // unused values at nodes without elements
    for (std::size_t n = 0; n < spacing.size(); ++n) {
        if (density[n] > 0.0) {
            spacing[n] = std::sqrt(area[n] / density[n]);
        }
    }
    return spacing;
}

Result<SpacingSpec> adaptedSpacing(const TriMesh &mesh, const ErrorEstimate &estimate, const AdaptTarget &target,
                                   const Progress &progress) {
    const Result<std::vector<double>> ofElements = elementSpacing(mesh, estimate, target, progress);
    if (!ofElements) {
        return ofElements.faults();
    }
    auto background = std::make_shared<BackgroundMesh>();
    background->nodes = mesh.nodes;
    background->values = nodalSpacing(mesh, *ofElements);
    background->elements.reserve(mesh.elements.size());
    for (const Element &nodes : mesh.elements) {
        background->elements.push_back({static_cast<std::uint32_t>(nodes[0]), static_cast<std::uint32_t>(nodes[1]),
                                        static_cast<std::uint32_t>(nodes[2])});
    }
    if (!limitGradation(*background, target.gradation, progress)) {
        return cancelled("choosing the node spacing");
    }
    SpacingSpec spec;
    spec.background = std::move(background);
    if (target.sizeMin > 0.0) {
        spec.minimum = target.sizeMin;
    }
    if (target.sizeMax < std::numeric_limits<double>::infinity()) {
        spec.maximum = target.sizeMax;
    }
    return spec;
}

} // namespace forefront
