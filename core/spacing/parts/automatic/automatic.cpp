#include "core/spacing/parts/automatic/automatic.hpp"

#include "core/spacing/parts/automatic/gap_finder.hpp"
#include "core/spacing/parts/curvature/curvature_sites.hpp"

#include <algorithm>
#include <utility>

namespace forefront {
namespace {

constexpr double kAcross = 45.0;          ///< elements along the diagonal of the domain's box
constexpr double kCurvedGradation = 0.18; ///< of curved domains; a steeper one leaves worse shapes beside bends
/// Sizes across a narrow place, √3: it takes two rows of equilateral triangles.
constexpr double kAcrossGap = 1.7320508075688772;
constexpr double kGapElements = 3.0e4;   ///< approximate number of elements to spend on narrow places ...
constexpr double kGapElementsEach = 8.0; ///< ... plus this many per domain segment

/// Returns the number of elements in the half of a gap beside its part of a segment, if their size is at least `floor`.
double elementsFor(const Gap &gap, double floor) {
    const double length = distance(gap.a, gap.b);
    const double size = std::max(gap.width / kAcrossGap, floor);
    return length / size * (1.0 + 1.1547 * gap.width / size); // 2/√3: rows of equilateral triangles
}

/// Returns the minimum size in narrow places that keeps their cost within the budget; 0 if none is needed.
double affordableFloor(const std::vector<Gap> &gaps, double longest, double budget) {
    const auto cost = [&](double floor) {
        double sum = 0.0;
        for (const Gap &gap : gaps) {
            sum += elementsFor(gap, floor);
        }
        return sum;
    };
    if (cost(0.0) <= budget) {
        return 0.0;
    }
    double low = 0.0;
    double high = longest;
    for (int step = 0; step < 40; ++step) {
        const double middle = 0.5 * (low + high);
        (cost(middle) > budget ? low : high) = middle;
    }
    return high;
}

/// Returns the segments, then the lone points as segments of zero length.
std::vector<PlacedSegment> thingsOf(const Domain &domain) {
    std::vector<PlacedSegment> things = placedSegments(domain);
    for (std::size_t i = 0; i < domain.points.size(); ++i) {
        const std::uint32_t node = domain.points[i].node;
        if (node < domain.nodes.size() && isUsable(domain.nodes[node])) {
            things.push_back(
                {domain.nodes[node], domain.nodes[node], static_cast<std::uint32_t>(domain.segments.size() + i)});
        }
    }
    return things;
}

} // namespace

double automaticMaximum(const Box2 &box) {
    return box.diagonal() / kAcross;
}

AutomaticSpacing automaticSpacing(const Domain &domain, const Box2 &box, double minimum, double gradation,
                                  double segmentsPerTurn, bool channels, const Progress &progress) {
    AutomaticSpacing automatic;
    automatic.maximum = automaticMaximum(box);
    const auto add = [&](const SizeSite &site, SiteReason reason, std::uint32_t index) {
        automatic.sites.add(limited(site, minimum, gradation), {SpacingOrigin::Automatic, reason, index});
    };
    const CurveChains chains = curveChains(domain);
    gradation = chains.list.empty() ? gradation : std::min(gradation, kCurvedGradation);
    std::vector<PlacedSegment> segments = placedSegments(domain);
    applyCurveLengths(domain, chains, segments);
    dropDominated(domain, gradation, segments);
    for (const PlacedSegment &segment : segments) {
        if (const double length = segment.wholeLength; length < automatic.maximum) {
            add(SizeSite::segment(segment.a, segment.b, length, gradation), SiteReason::SegmentLength, segment.index);
        }
    }
    if (segmentsPerTurn > 0.0) {
        addCurvatureSites(domain, chains, segmentsPerTurn, minimum, gradation, SpacingOrigin::Automatic, true, progress,
                          automatic.sites);
    }
    std::vector<PlacedSegment> placed = thingsOf(domain);
    applyCurveLengths(domain, chains, placed);
    const SegmentIndex things(std::move(placed));
    const GapFinder finder(domain, things, automatic.maximum, kFinestGap * box.diagonal(), progress);
    std::vector<Gap> gaps = finder.find();
    if (!channels) {
        std::erase_if(gaps, [](const Gap &gap) { return !gap.corner; });
    }
    const double budget = kGapElements + kGapElementsEach * static_cast<double>(domain.segments.size());
    const double floor = affordableFloor(gaps, automatic.maximum, budget);
    for (const Gap &gap : gaps) {
        const double size = std::max(gap.width / kAcrossGap, floor);
        const double length = distance(gap.a, gap.b);
        const double own = std::min(automatic.maximum, gap.wholeLength);
        if (size < 0.95 * own && length > 0.0) {
            add(SizeSite::segment(gap.a, gap.b, size, gradation), gap.corner ? SiteReason::Corner : SiteReason::Channel,
                gap.segment);
        }
    }
    for (std::uint32_t i = 0; i < things.segments.size(); ++i) {
        const PlacedSegment &thing = things.segments[i];
        if (thing.index >= domain.segments.size()) {
            const std::uint32_t node = domain.points[thing.index - domain.segments.size()].node;
            add(SizeSite::point(thing.a, std::max(finder.clearance(i), floor), gradation), SiteReason::LonePoint, node);
        }
    }
    automatic.sites.dropDominated();
    return automatic;
}

} // namespace forefront
