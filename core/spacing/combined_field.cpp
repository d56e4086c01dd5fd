#include "core/spacing/combined_field.hpp"

#include "core/base/assert.hpp"

#include <array>
#include <cstdio>

namespace forefront {
namespace {

std::string shortNumber(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

const char *capWords(SpacingOrigin origin) {
    switch (origin) {
    case SpacingOrigin::Minimum:
        return "least spacing";
    case SpacingOrigin::Maximum:
        return "greatest spacing";
    case SpacingOrigin::Automatic:
        return "automatic: size of the domain";
    default:
        return "constant";
    }
}

/// Box corners and, for the lower bound, the nearest approach of a site to the box.
double greatestOverBox(const SizeSite &site, const Box2 &box) {
    return std::max(
        {site.at(box.min), site.at(box.max), site.at({box.min.x, box.max.y}), site.at({box.max.x, box.min.y})});
}
double leastOverBox(const SizeSite &site, const Box2 &box) {
    return std::max(site.size, site.at(box.centre()) - site.growth * 0.5 * box.diagonal());
}

} // namespace

void ConstantField::atMany(std::span<const Vec2> points, std::span<double> rho) const {
    FOREFRONT_ASSERT(points.size() == rho.size());
    std::fill(rho.begin(), rho.end(), rho_);
}

SpacingSample ConstantField::sample(Vec2) const {
    return {rho_, origin_, 0, capWords(origin_)};
}

SpacingSample ExpressionField::sample(Vec2 p) const {
    return {expression_.at(p), SpacingOrigin::Expression, 0, "expression " + expression_.text()};
}

CombinedField::CombinedField(SpacingParts parts, const Box2 &box) : parts_(std::move(parts)) {
    minimum_ = maximum_ = parts_.cap;
    const auto include = [this](double low, double high) {
        minimum_ = std::min(minimum_, low);
        maximum_ = std::min(maximum_, high);
    };
    for (const SizeSite &site : parts_.few.sites) {
        include(leastOverBox(site, box), greatestOverBox(site, box));
    }
    if (parts_.expression) {
        include(parts_.expression->minimum(), parts_.expression->maximum());
    }
    if (parts_.background) {
        const bool filled = parts_.filler.has_value();
        include(
            std::min(parts_.background->minimum(), filled ? parts_.filler->minimum() : parts_.background->minimum()),
            filled ? std::max(parts_.background->maximum(), parts_.fillerCap)
                   : std::numeric_limits<double>::infinity());
    }
    if (parts_.paint) {
        include(parts_.paint->minimum(), std::numeric_limits<double>::infinity());
    }
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
            describeSite(parts_.few.sites[i], parts_.few.labels[i], p, sample);
        }
    }
    if (parts_.expression && parts_.expression->at(p) < sample.rho) {
        sample = {parts_.expression->at(p), SpacingOrigin::Expression, 0, "expression " + parts_.expression->text()};
    }
    if (parts_.background && backgroundAt(p) < sample.rho) {
        describeBackground(p, sample);
    }
    if (parts_.paint && parts_.paint->at(p) < sample.rho) {
        sample = {parts_.paint->at(p), SpacingOrigin::Paint, 0, "painted"};
    }
    if (parts_.tree && parts_.tree->at(p) < sample.rho) {
        const std::size_t winner = parts_.tree->winner(p);
        describeSite(parts_.tree->sites()[winner], parts_.treeLabels[winner], p, sample);
    }
    if (sample.rho <= parts_.minimum) {
        sample.origin = SpacingOrigin::Minimum;
        sample.describe = "least spacing";
    }
    sample.rho = inlineAt(p);
    return sample;
}

void CombinedField::describeBackground(Vec2 p, SpacingSample &sample) const {
    if (const auto triangle = parts_.background->triangleAt(p)) {
        sample = {backgroundAt(p), SpacingOrigin::Background, *triangle,
                  "background mesh, triangle " + std::to_string(*triangle)};
    } else if (parts_.filler->at(p) < parts_.fillerCap) {
        const std::size_t winner = parts_.filler->winner(p);
        describeSite(parts_.filler->sites()[winner], parts_.fillerLabels[winner], p, sample);
    } else {
        sample = {parts_.fillerCap, SpacingOrigin::Automatic, 0, capWords(SpacingOrigin::Automatic)};
    }
}

void CombinedField::describeSite(const SizeSite &site, const SiteLabel &label, Vec2 p, SpacingSample &sample) const {
    sample.rho = site.at(p);
    sample.origin = label.origin;
    sample.source = label.index;
    const std::string number = std::to_string(label.index);
    const std::string automatic = label.origin == SpacingOrigin::Automatic ? "automatic: " : "";
    const std::string limit = "limited by gradation " + shortNumber(parts_.gradation) + " from ";
    switch (label.reason) {
    case SiteReason::Source: {
        const std::string &name = parts_.sourceNames[label.index];
        sample.describe = name.empty() ? "source " + number : "source '" + name + "'";
        return;
    }
    case SiteReason::PaintEdge:
        sample.describe = limit + "the painted patch";
        break;
    case SiteReason::BackgroundEdge:
        sample.describe = limit + "the background mesh";
        break;
    case SiteReason::ExpressionEdge:
        sample.describe = limit + "the expression";
        break;
    case SiteReason::SegmentLength:
        sample.describe = automatic + "length of boundary segment " + number;
        return;
    case SiteReason::Channel:
        sample.describe = automatic + "narrow channel at boundary segment " + number;
        return;
    case SiteReason::Corner:
        sample.describe = automatic + "sharp corner at node " + number;
        return;
    case SiteReason::LonePoint:
        sample.describe = automatic + "near point " + number;
        return;
    }
    const Vec2 from = site.nearest(p);
    sample.describe += " at (" + shortNumber(from.x) + ", " + shortNumber(from.y) + ")";
    sample.origin = SpacingOrigin::Gradation;
}

} // namespace forefront
