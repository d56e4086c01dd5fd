#include "core/spacing/sites/site_words.hpp"

#include "core/base/number_text.hpp"

namespace forefront {
namespace {

/// Describes where a site's demand comes from: a place from which the gradation limit spreads it; may be empty.
std::string reachedFrom(const SiteLabel &label, const SiteWords &words) {
    switch (label.reason) {
    case SiteReason::PaintEdge:
        return "the painted patch";
    case SiteReason::BackgroundEdge:
        return "the background mesh";
    case SiteReason::ExpressionEdge:
        return "the expression";
    case SiteReason::RegionEdge:
        return "region '" + words.regions[label.index] + "'";
    default:
        return {};
    }
}

std::string describe(const SiteLabel &label, const SiteWords &words) {
    const std::string number = std::to_string(label.index);
    switch (label.reason) {
    case SiteReason::Source:
        return sourceWords(words, label.index);
    case SiteReason::RegionSize:
        return "size of region '" + words.regions[label.index] + "'";
    case SiteReason::PartSize:
        return "size of '" + words.parts.at(label.index) + "'";
    case SiteReason::NodeSize:
        return "size at " + words.nodes[label.index];
    case SiteReason::SegmentLength:
        return "length of boundary segment " + number;
    case SiteReason::Bend:
        return "bend of the curve at boundary segment " + number;
    case SiteReason::Channel:
        return "narrow channel at boundary segment " + number;
    case SiteReason::Corner:
        return "sharp corner at boundary segment " + number;
    case SiteReason::LonePoint:
        return "near point " + number;
    default:
        return {};
    }
}

} // namespace

std::string sourceWords(const SiteWords &words, std::uint32_t source) {
    const std::string &name = words.sources[source];
    return name.empty() ? "source " + std::to_string(source) : "source '" + name + "'";
}

SpacingSample sampleSite(const SizeSite &site, const SiteLabel &label, const SiteWords &words, Vec2 p) {
    if (const std::string origin = reachedFrom(label, words); !origin.empty()) {
        const Vec2 from = site.nearest(p);
        return {site.at(p), SpacingOrigin::Gradation, label.index,
                "limited by gradation " + numberText(words.gradation, 4) + " from " + origin + " at (" +
                    numberText(from.x, 4) + ", " + numberText(from.y, 4) + ")"};
    }
    const char *const prefix = label.origin == SpacingOrigin::Automatic ? "automatic: " : "";
    return {site.at(p), label.origin, label.index, prefix + describe(label, words)};
}

} // namespace forefront
