#include "core/spacing/combined_field.hpp"

#include "core/base/assert.hpp"

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
    for (std::size_t i = 0; i < points.size(); ++i) {
        rho[i] = inlineAt(points[i]);
    }
}

SpacingSample CombinedField::sample(Vec2 p) const {
    SpacingSample sample{parts_.cap, parts_.capOrigin, 0, capWords(parts_.capOrigin)};
    for (std::size_t i = 0; i < parts_.few.sites.size(); ++i) {
        if (parts_.few.sites[i].at(p) < sample.rho) {
            sample = sampleSite(parts_.few.sites[i], parts_.few.labels[i], parts_.words, p);
        }
    }
    forPoints([&](const auto &part) {
        if (part.at(p) < sample.rho) {
            sample = part.sample(p, parts_.words);
        }
    });
    if (parts_.tree && parts_.tree->at(p) < sample.rho) {
        const std::size_t winner = parts_.tree->winner(p);
        sample = sampleSite(parts_.tree->sites()[winner], parts_.treeLabels[winner], parts_.words, p);
    }
    if (sample.rho <= parts_.minimum) {
        sample.origin = SpacingOrigin::Minimum;
        sample.describe = capWords(SpacingOrigin::Minimum);
    }
    sample.rho = inlineAt(p);
    return sample;
}

} // namespace forefront
