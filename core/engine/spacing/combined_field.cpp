#include "core/engine/spacing/combined_field.hpp"

#include "core/engine/base/assert.hpp"

namespace forefront {
namespace {

const char *capWords(SpacingOrigin origin) {
    switch (origin) {
    case SpacingOrigin::Minimum:
        return "minimum spacing";
    case SpacingOrigin::Maximum:
        return "maximum spacing";
    case SpacingOrigin::Automatic:
        return "automatic: size of the domain";
    default:
        return "constant";
    }
}

/// Returns the rule that sets the cap, as a label that no site has.
SiteLabel capRule(SpacingOrigin origin) {
    return {origin, SiteReason::Source, 0};
}

/// Returns the rule of a sample of a part evaluated point by point: the same as that of the sites from which the
/// gradation limit spreads it.
SiteLabel partRule(const SpacingSample &sample) {
    switch (sample.origin) {
    case SpacingOrigin::Expression:
        return {sample.origin, SiteReason::ExpressionEdge, 0};
    case SpacingOrigin::Function:
        return {sample.origin, SiteReason::FunctionEdge, 0};
    case SpacingOrigin::Paint:
        return {sample.origin, SiteReason::PaintEdge, 0};
    case SpacingOrigin::Background:
        return {sample.origin, SiteReason::BackgroundEdge, 0};
    case SpacingOrigin::Region:
        return {sample.origin, SiteReason::RegionEdge, sample.source};
    default:
        return {sample.origin, SiteReason::Source, sample.source};
    }
}

/// Returns true if two labels are of one rule. Lengths, bends, gaps and corners of all segments are one rule each,
/// since the neighbour of a segment demands nearly the same.
bool sameRule(const SiteLabel &a, const SiteLabel &b) {
    const bool each = a.reason <= SiteReason::NodeSize; // not made from the whole boundary
    // The size and the maximum area of a region are one rule.
    const auto reason = [](const SiteLabel &label) {
        return label.reason == SiteReason::RegionSize ? SiteReason::RegionEdge : label.reason;
    };
    return a.origin == b.origin && reason(a) == reason(b) && (a.index == b.index || !each);
}

/// Returns the maximum of a site over a box, which is at a corner.
double maximumOverBox(const SizeSite &site, const Box2 &box) {
    return std::max(
        {site.at(box.min), site.at(box.max), site.at({box.min.x, box.max.y}), site.at({box.max.x, box.min.y})});
}
/// Returns a lower bound of a site over a box.
double minimumOverBox(const SizeSite &site, const Box2 &box) {
    return std::max(site.size, site.at(box.centre()) - site.growth * 0.5 * box.diagonal());
}

} // namespace

void FieldParts::lowerCap(double size, SpacingOrigin origin) {
    if (size < cap) {
        cap = size;
        capOrigin = origin;
        capIsRule = true;
    }
}

void ConstantField::atMany(std::span<const Vec2> points, std::span<double> rho) const {
    FOREFRONT_ASSERT(points.size() == rho.size());
    std::fill(rho.begin(), rho.end(), rho_);
}

SpacingSample ConstantField::sample(Vec2) const {
    return {rho_, origin_, 0, capWords(origin_)};
}

void FilledBackground::fill(double cap, SiteTree sites, std::vector<SiteLabel> labels) {
    cap_ = cap;
    sites_ = std::move(sites);
    labels_ = std::move(labels);
}

SpacingSample FilledBackground::sample(Vec2 p, const SiteWords &words) const {
    if (const auto triangle = mesh_.triangleAt(p)) {
        return {at(p), SpacingOrigin::Background, *triangle, "background mesh, triangle " + std::to_string(*triangle)};
    }
    if (sites_->at(p) < cap_) {
        const std::size_t winner = sites_->winner(p);
        return sampleSite(sites_->sites()[winner], labels_[winner], words, p);
    }
    return {cap_, SpacingOrigin::Automatic, 0, capWords(SpacingOrigin::Automatic)};
}

CombinedField::CombinedField(FieldParts parts, const Box2 &box) : parts_(std::move(parts)) {
    minimum_ = maximum_ = parts_.cap;
    const auto include = [this](double low, double high) {
        minimum_ = std::min(minimum_, low);
        maximum_ = std::min(maximum_, high);
    };
    for (const SizeSite &site : parts_.few.sites) {
        include(minimumOverBox(site, box), maximumOverBox(site, box));
    }
    forPoints([&](const auto &part) { include(part.minimum(), part.maximum()); });
    if (parts_.tree) {
        include(parts_.tree->minimum(), parts_.tree->maximum());
    }
    minimum_ = std::max(minimum_, parts_.minimum);
    maximum_ = std::max(maximum_, parts_.minimum);
}

void CombinedField::atMany(std::span<const Vec2> points, std::span<double> rho) const {
    FOREFRONT_ASSERT(points.size() == rho.size());
    if (const auto &function = std::get<std::optional<FunctionSpacing>>(parts_.points)) {
        function->atMany(points, rho); // once for all, which can be faster
        for (std::size_t i = 0; i < points.size(); ++i) {
            rho[i] = std::min(rho[i], withoutTreeAndFunction(points[i]));
        }
    } else {
        for (std::size_t i = 0; i < points.size(); ++i) {
            rho[i] = withoutTreeAndFunction(points[i]);
        }
    }
    if (parts_.tree) {
        parts_.tree->lowerMany(points, rho);
    }
    for (double &value : rho) {
        value = std::max(value, parts_.minimum);
    }
}

SpacingSample CombinedField::sample(Vec2 p) const {
    SpacingSample sample{parts_.cap, parts_.capOrigin, 0, capWords(parts_.capOrigin)};
    SiteLabel rule = capRule(parts_.capOrigin);
    for (std::size_t i = 0; i < parts_.few.sites.size(); ++i) {
        if (parts_.few.sites[i].at(p) < sample.rho) {
            rule = parts_.few.labels[i];
            sample = sampleSite(parts_.few.sites[i], rule, parts_.words, p);
        }
    }
    forPoints([&](const auto &part) {
        if (part.at(p) < sample.rho) {
            sample = part.sample(p, parts_.words);
            rule = partRule(sample);
        }
    });
    if (parts_.tree && parts_.tree->at(p) < sample.rho) {
        const std::size_t winner = parts_.tree->winner(p);
        rule = parts_.treeLabels[winner];
        sample = sampleSite(parts_.tree->sites()[winner], rule, parts_.words, p);
    }
    if (sample.rho <= parts_.minimum) {
        sample.origin = SpacingOrigin::Minimum;
        sample.describe = capWords(SpacingOrigin::Minimum);
        rule = capRule(SpacingOrigin::Minimum);
    }
    sample.rho = inlineAt(p);
    sample.runnerUp = runnerUp(p, rule);
    if (sample.runnerUp) { // the tree is less exact than its sites
        sample.runnerUp->rho = std::max(sample.runnerUp->rho, sample.rho);
    }
    return sample;
}

std::optional<SpacingRunnerUp> CombinedField::runnerUp(Vec2 p, const SiteLabel &winner) const {
    SpacingRunnerUp least{std::numeric_limits<double>::infinity(), {}};
    if (parts_.capIsRule && !sameRule(winner, capRule(parts_.capOrigin))) {
        least = {parts_.cap, capWords(parts_.capOrigin)};
    }
    const auto compare = [&](const std::vector<SizeSite> &sites, const std::vector<SiteLabel> &labels) {
        std::size_t best = sites.size();
        for (std::size_t i = 0; i < sites.size(); ++i) {
            if (!sameRule(labels[i], winner) &&
                sites[i].at(p) < (best < sites.size() ? sites[best].at(p) : least.rho)) {
                best = i;
            }
        }
        if (best < sites.size()) {
            least = {sites[best].at(p), sampleSite(sites[best], labels[best], parts_.words, p).describe};
        }
    };
    compare(parts_.few.sites, parts_.few.labels);
    forPoints([&](const auto &part) {
        if (!(part.at(p) < least.rho)) {
            return;
        }
        SpacingSample sample = part.sample(p, parts_.words);
        if (!sameRule(partRule(sample), winner)) {
            least = {sample.rho, std::move(sample.describe)};
        } else if (sample.runnerUp && sample.runnerUp->rho < least.rho) {
            least = std::move(*sample.runnerUp);
        }
    });
    if (parts_.tree) {
        compare(parts_.tree->sites(), parts_.treeLabels);
    }
    return least.rho < std::numeric_limits<double>::infinity() ? std::optional(std::move(least)) : std::nullopt;
}

} // namespace forefront
