#include "core/drawing/commands/limit_fix.hpp"

#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/engine/base/assert.hpp"
#include "core/engine/base/note.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/refine/least_angle.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace forefront {
namespace {

constexpr double kGentlestFix = 0.02;      ///< gradation below which elements hardly grow at all
constexpr double kMostAcross = 50.0;       ///< elements across narrow places
constexpr double kMargin = 0.9;            ///< of a maximum size: single edges are longer than the spacing
constexpr double kMinimumOverLength = 1.2; ///< single edges are shorter than the spacing

std::string changeText(const char *what, const std::optional<double> &before, const char *none, double after) {
    return std::string(what) + ' ' + (before ? numberText(*before, 6) : none) + " \xe2\x86\x92 " + numberText(after, 6);
}

std::optional<LimitFix> fixWith(Result<Document> next, std::string change) {
    if (!next) {
        return std::nullopt;
    }
    return LimitFix{std::move(change), *std::move(next)};
}

/// `now`: the gradation in force, which may be gentler than the given one.
std::optional<LimitFix> fixGrowth(const Document &document, const LimitVerdict &verdict, double now) {
    const std::optional<double> given = document.spacing.gradation;
    if (now <= kGentlestFix) {
        return std::nullopt;
    }
    const double factor = std::clamp((verdict.bound - 1.0) / (verdict.worst - 1.0), 0.4, 0.8);
    const double next = std::max(kGentlestFix, roundedTo(factor * now, 2));
    return fixWith(setGradation(document, next), changeText("gradation", given, "auto", next));
}

std::optional<LimitFix> fixAcross(const Document &document, const LimitVerdict &verdict) {
    const std::optional<double> given = document.spacing.elementsAcross;
    const double wanted = std::ceil(verdict.bound);
    const double next = given && *given >= wanted ? std::floor(*given) + 1.0 : wanted;
    if (next > kMostAcross) {
        return std::nullopt;
    }
    return fixWith(setElementsAcross(document, next), changeText("elements per gap", given, "auto", next));
}

/// A minimum size above the maximum is refused by the command, and so is no fix.
std::optional<LimitFix> fixMinimumLength(const Document &document, const LimitVerdict &verdict) {
    const std::optional<double> given = document.spacing.minimum;
    const double next = roundedTo(kMinimumOverLength * verdict.bound, 2);
    if (given && *given >= next) {
        return std::nullopt; // the outline has shorter segments
    }
    return fixWith(setLimits(document, next, document.spacing.maximum),
                   changeText("minimum size", given, "none", next));
}

std::optional<LimitFix> fixMaximumLength(const Document &document, const LimitVerdict &verdict) {
    const std::optional<double> given = document.spacing.maximum;
    const double reach = given ? std::min(*given, *given * verdict.bound / verdict.worst) : verdict.bound;
    const double next = roundedTo(kMargin * reach, 2);
    return fixWith(setLimits(document, document.spacing.minimum, next),
                   changeText("maximum size", given, "none", next));
}

std::optional<LimitFix> fixByImproving(const Document &document) {
    if (document.options.improve == ImproveLevel::Best) {
        return std::nullopt;
    }
    Document next = document;
    next.options.improve = ImproveLevel::Best;
    return LimitFix{"improve " + std::string(wordOf(document.options.improve)) + " \xe2\x86\x92 best", std::move(next)};
}

/// `angle`: the least one that meets the limit, degrees. No triangle whose angles are at least that has one above
/// 180 degrees minus twice of it.
std::optional<LimitFix> fixAngle(const Document &document, double angle) {
    const std::optional<double> given = document.options.leastAngle;
    const bool possible = document.options.elements == Elements::Triangles && angle > 0.0 && angle <= kMaxLeastAngle;
    if (!possible || (given && *given >= angle)) {
        return fixByImproving(document);
    }
    Document next = document;
    next.options.leastAngle = angle;
    return LimitFix{changeText("least angle", given, "none", angle), std::move(next)};
}

/// Returns true if the worst place of a limit is farther beyond it after a fix than before, by more than a tenth of the
/// limit: such a fix is not worth fewer violations.
bool makesWorse(const LimitVerdict &before, const LimitVerdict &after) {
    constexpr double kNoticeable = 0.1;
    const double limit = std::abs(before.bound);
    return after.broken > 0 &&
           std::abs(after.worst - after.bound) > std::abs(before.worst - before.bound) + kNoticeable * limit;
}

} // namespace

std::optional<LimitFix> fixOf(const Document &document, const LimitVerdict &verdict, const SpacingField *spacing) {
    if (verdict.met() || verdict.broken == 0) {
        return std::nullopt;
    }
    switch (verdict.limit) {
    case MeshLimit::MaxGrowth:
        return fixGrowth(document, verdict,
                         spacing != nullptr ? spacing->gradation()
                                            : document.spacing.gradation.value_or(kDefaultGradation));
    case MeshLimit::MinAcross:
        return fixAcross(document, verdict);
    case MeshLimit::MinLength:
        return fixMinimumLength(document, verdict);
    case MeshLimit::MaxLength:
        return fixMaximumLength(document, verdict);
    case MeshLimit::MinAngle:
        return fixAngle(document, verdict.bound);
    case MeshLimit::MaxAngle:
        return fixAngle(document, 0.5 * (180.0 - verdict.bound));
    case MeshLimit::MaxAspect: // the height of layers is given
        return document.layers.empty() ? fixByImproving(document) : std::nullopt;
    case MeshLimit::MaxLayerAspect: // their heights are given
    case MeshLimit::MinIslandArea:  // islands are drawn
        return std::nullopt;
    default:
        return fixByImproving(document);
    }
}

std::size_t violations(std::span<const LimitVerdict> verdicts) {
    return std::accumulate(verdicts.begin(), verdicts.end(), std::size_t{0},
                           [](std::size_t sum, const LimitVerdict &verdict) { return sum + verdict.broken; });
}

std::string whyNoBetter(std::span<const LimitVerdict> before, std::span<const LimitVerdict> after) {
    FOREFRONT_ASSERT(before.size() == after.size());
    for (std::size_t k = 0; k < before.size(); ++k) {
        if (before[k].broken > 0 && makesWorse(before[k], after[k])) {
            const MeshLimit limit = before[k].limit;
            return std::string("the ") + limitInfo(limit).name + " became " + valueText(limit, after[k].worst) +
                   " instead of " + valueText(limit, before[k].worst);
        }
    }
    const std::size_t earlier = violations(before), now = violations(after);
    return now < earlier    ? std::string()
           : now == earlier ? countText(now, "place") + " violate" + (now == 1 ? "s" : "") + " a limit, as before"
                            : countText(now, "place") + " violate a limit instead of " + std::to_string(earlier);
}

} // namespace forefront
