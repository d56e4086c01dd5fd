#include "core/engine/spacing/tolerance_field.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/base/cancelled.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"
#include "core/engine/spacing/parts/tolerance/tolerance_sites.hpp"

#include <algorithm>
#include <utility>

namespace forefront {
namespace {

constexpr SpreadOptions kCurveSpread{.many = 2048};

} // namespace

Result<std::shared_ptr<const SpacingField>> ToleranceField::limit(std::shared_ptr<const SpacingField> others,
                                                                  const SpacingSpec &spec, const Domain &domain,
                                                                  const Progress &progress) {
    if (domain.curves.empty()) {
        return others;
    }
    SiteSet sites;
    const OtherSizes sizes{[&others](Vec2 p) { return others->at(p); }, others->maximum()};
    addToleranceSites(domain, spec.placed.counts(), sizes, spec.minimum.value_or(0.0),
                      spec.gradation.value_or(kDefaultGradation), progress, sites);
    std::optional<SiteTree> tree;
    if (!sites.sites.empty() && !progress.cancelled()) {
        tree = SiteTree::build(std::move(sites.sites), spacingBox(domain), progress, kCurveSpread);
    }
    if (progress.cancelled()) {
        return cancelled("preparing the spacing");
    }
    if (!tree) {
        return others;
    }
    std::shared_ptr<ToleranceField> field(
        new ToleranceField(std::move(others), *std::move(tree), std::move(sites.labels)));
    field->words_.boundaryNames = domain.boundaryNames;
    for (const DomainSegment &segment : domain.segments) {
        field->words_.segmentTags.push_back(segment.tag);
    }
    return std::shared_ptr<const SpacingField>(std::move(field));
}

ToleranceField::ToleranceField(std::shared_ptr<const SpacingField> others, SiteTree sites,
                               std::vector<SiteLabel> labels)
    : others_(std::move(others)), sites_(std::move(sites)), labels_(std::move(labels)) {
    describeAs(*others_);
}

double ToleranceField::at(Vec2 p) const {
    return std::min(others_->at(p), sites_.at(p));
}

void ToleranceField::atMany(std::span<const Vec2> points, std::span<double> rho) const {
    FOREFRONT_ASSERT(points.size() == rho.size());
    others_->atMany(points, rho);
    sites_.lowerMany(points, rho);
}

SpacingSample ToleranceField::sample(Vec2 p) const {
    SpacingSample other = others_->sample(p);
    const std::size_t winner = sites_.winner(p);
    SpacingSample own = sampleSite(sites_.sites()[winner], labels_[winner], words_, p);
    own.rho = sites_.at(p);
    const bool wins = own.rho < other.rho;
    SpacingSample &first = wins ? own : other, &second = wins ? other : own;
    if (wins || !first.runnerUp || second.rho < first.runnerUp->rho) {
        first.runnerUp = SpacingRunnerUp{second.rho, std::move(second.describe)};
    }
    return std::move(first);
}

double ToleranceField::minimum() const {
    return std::min(others_->minimum(), sites_.minimum());
}

} // namespace forefront
