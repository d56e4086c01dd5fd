#include "core/engine/spacing/sites/site_words.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/domain.hpp"

namespace forefront {
namespace {

/// Names the rule whose size the gradation limit spreads to a site; empty if there is none.
std::string reachedFrom(const SiteLabel &label, const SiteWords &words) {
    switch (label.reason) {
    case SiteReason::PaintEdge:
        return "the painted patch";
    case SiteReason::BackgroundEdge:
        return "the background mesh";
    case SiteReason::ExpressionEdge:
        return "the expression";
    case SiteReason::FunctionEdge:
        return "the size function";
    case SiteReason::RegionEdge:
        return "region '" + words.regions[label.index] + "'";
    case SiteReason::AutomaticEdge:
        return "the automatic sizes";
    default:
        return {};
    }
}

/// Returns "'pier' at (3, 4)".
std::string boundaryAt(const SiteLabel &label, const SiteWords &words, Vec2 at) {
    return "'" + boundaryName(words.boundaryNames, words.segmentTags[label.index]) + "' at " + placeText(at);
}

/// Describes the demand of a site whose nearest place is `at`.
std::string describe(const SiteLabel &label, const SiteWords &words, Vec2 at) {
    switch (label.reason) {
    case SiteReason::Source:
        return sourceWords(words, label.index);
    case SiteReason::RegionSize:
        return "size of region '" + words.regions[label.index] + "'";
    case SiteReason::PartSize:
        return "size of '" + words.parts.at(label.index) + "'";
    case SiteReason::SegmentSize:
        return "size of a segment of " + boundaryAt(label, words, at);
    case SiteReason::NodeSize:
        return "size at " + words.nodes[label.index];
    case SiteReason::SegmentLength:
        return "length of a segment of " + boundaryAt(label, words, at);
    case SiteReason::Bend:
        return "bend of " + boundaryAt(label, words, at);
    case SiteReason::Tolerance:
        return "curve tolerance of " + boundaryAt(label, words, at);
    case SiteReason::KeptSegment:
        return "kept segment of " + boundaryAt(label, words, at);
    case SiteReason::Channel:
        return "narrow channel beside " + boundaryAt(label, words, at);
    case SiteReason::Corner:
        return "sharp corner of " + boundaryAt(label, words, at);
    case SiteReason::LonePoint:
        return "near the point " + placeText(at);
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
    const Vec2 from = site.nearest(p);
    if (const std::string origin = reachedFrom(label, words); !origin.empty()) {
        return {site.at(p), SpacingOrigin::Gradation, label.index,
                "limited by gradation " + numberText(site.growth, 4) + " from " + origin + " at " + placeText(from)};
    }
    const char *const prefix = label.origin == SpacingOrigin::Automatic ? "automatic: " : "";
    return {site.at(p), label.origin, label.index, prefix + describe(label, words, from)};
}

} // namespace forefront
