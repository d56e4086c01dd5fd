#include "core/engine/spacing/replaced_field.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/base/cancelled.hpp"
#include "core/engine/spacing/field_of_rules.hpp"
#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace forefront {
namespace {

constexpr double kBeyond = 1e3;            ///< size where no rule is kept, in diagonals of the domain's box
constexpr SpreadOptions kSpread{256, 4.0}; ///< as for the edges of paint: there are many, and meshes follow the brush

/// Returns the rules that paint does not replace, with the paint itself.
SpacingSpec keptRules(const SpacingSpec &spec, double beyond) {
    SpacingSpec kept;
    kept.size = beyond; // or automatic spacing would apply
    kept.paint = spec.paint;
    kept.paint.replaces = false;
    kept.partSizes = spec.partSizes;
    kept.placed = spec.placed;
    kept.fromBoundary = spec.fromBoundary;
    kept.minimum = spec.minimum;
    kept.maximum = spec.maximum;
    kept.gradation = spec.gradation;
    return kept;
}

double largestOf(const PaintedSpacing &paint) {
    float largest = 0.0F;
    for (const auto &[key, tile] : paint.tiles) {
        for (std::size_t k = 0; tile && k < tile->size(); ++k) {
            largest = std::max(largest, (*tile)[k]);
        }
    }
    return static_cast<double>(largest);
}

} // namespace

Result<std::shared_ptr<const SpacingField>> ReplacedField::build(const SpacingSpec &spec, const Domain &domain,
                                                                 const Progress &progress) {
    SpacingSpec others = spec;
    others.paint = {};
    const Box2 box = spacingBox(domain);
    const double beyond = kBeyond * box.diagonal();
    auto around = fieldOfRules(others, domain, progress);
    if (!around) {
        return around;
    }
    auto kept = fieldOfRules(keptRules(spec, beyond), domain, progress);
    if (!kept) {
        return kept;
    }
    auto paint = PaintedPart::build(spec.paint, box, spec.minimum.value_or(0.0));
    if (!paint) {
        return paint.faults();
    }
    std::shared_ptr<ReplacedField> field(new ReplacedField(*std::move(paint)));
    field->describeAs(**around);
    field->others_ = *std::move(around);
    field->kept_ = *std::move(kept);
    field->largest_ = largestOf(spec.paint);
    field->farthest_ = beyond;
    const double gradation = spec.gradation.value_or(kDefaultGradation);
    std::vector<SizeSite> sites;
    for (const PaintedPart::Border &border : PaintedPart::borderOf(spec.paint)) {
        const double rho = field->others_->at(border.at);
        if (rho < border.beside) { // otherwise the paint is the finer one, and its own reach limits the surroundings
            sites.push_back(SizeSite::point(border.at, rho, gradation));
        }
    }
    if (!sites.empty()) {
        field->border_ = SiteTree::build(std::move(sites), box, progress, kSpread);
    }
    if (progress.cancelled()) {
        return cancelled("preparing the spacing");
    }
    return std::shared_ptr<const SpacingField>(std::move(field));
}

double ReplacedField::at(Vec2 p) const {
    const double kept = kept_->at(p);
    return std::min(kept, painted(p) ? fromBorder(p) : others_->at(p));
}

void ReplacedField::atMany(std::span<const Vec2> points, std::span<double> rho) const {
    FOREFRONT_ASSERT(points.size() == rho.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        rho[i] = at(points[i]);
    }
}

SpacingSample ReplacedField::sample(Vec2 p) const {
    SpacingSample kept = kept_->sample(p), others = others_->sample(p);
    if (kept.runnerUp && kept.runnerUp->rho >= farthest_) {
        kept.runnerUp.reset(); // not a rule
    }
    if (painted(p)) {
        if (const double limit = fromBorder(p); limit < kept.rho) {
            kept.runnerUp = SpacingRunnerUp{kept.rho, kept.describe};
            kept.rho = limit;
            kept.origin = SpacingOrigin::Gradation;
            kept.describe = "growth from the spacing around the paint";
        }
        return kept;
    }
    SpacingSample &winner = kept.rho < others.rho ? kept : others;
    SpacingSample &loser = kept.rho < others.rho ? others : kept;
    if (loser.rho < farthest_ && loser.describe != winner.describe &&
        (!winner.runnerUp || loser.rho < winner.runnerUp->rho)) {
        winner.runnerUp = SpacingRunnerUp{loser.rho, std::move(loser.describe)};
    }
    return winner;
}

double ReplacedField::minimum() const {
    return std::min(others_->minimum(), kept_->minimum());
}

double ReplacedField::maximum() const {
    return std::max(others_->maximum(), std::min(largest_, kept_->maximum()));
}

} // namespace forefront
