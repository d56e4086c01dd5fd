#include "core/engine/spacing/parts/automatic/automatic.hpp"

#include "core/engine/spacing/parts/automatic/gap_finder.hpp"
#include "core/engine/spacing/parts/curvature/curvature_sites.hpp"

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

/// Returns the segments, then the lone points as segments of zero length. A point at the end of a segment is not alone.
std::vector<PlacedSegment> thingsOf(const Domain &domain) {
    std::vector<PlacedSegment> things = placedSegments(domain);
    std::vector<std::uint8_t> isEnd(domain.nodes.size(), 0);
    for (const PlacedSegment &segment : things) {
        isEnd[domain.segments[segment.index].a] = isEnd[domain.segments[segment.index].b] = 1;
    }
    for (std::size_t i = 0; i < domain.points.size(); ++i) {
        const std::uint32_t node = domain.points[i].node;
        if (node < domain.nodes.size() && isUsable(domain.nodes[node]) && isEnd[node] == 0) {
            things.push_back(
                {domain.nodes[node], domain.nodes[node], static_cast<std::uint32_t>(domain.segments.size() + i)});
        }
    }
    return things;
}

/// Adds the sites of the automatic spacing. Each step frees its own data, which takes more memory than the sites.
class AutomaticSites {
  public:
    AutomaticSites(const Domain &domain, const LazyFaces &faces, double minimum, double maximum, double gradation,
                   SiteSet &sites)
        : domain_(domain), faces_(faces), chains_(curveChains(domain)), minimum_(minimum), maximum_(maximum),
          gradation_(chains_.list.empty() ? gradation : std::min(gradation, kCurvedGradation)), sites_(sites) {}

    double gradation() const { return gradation_; }

    void addLengths() {
        std::vector<PlacedSegment> segments = placedSegments(domain_);
        applyCurveLengths(domain_, chains_, segments);
        dropDominated(domain_, gradation_, segments);
        reserve(segments.size());
        for (const PlacedSegment &segment : segments) {
            if (const double length = segment.wholeLength; length < maximum_) {
                add(SizeSite::segment(segment.a, segment.b, length, gradation_), SiteReason::SegmentLength,
                    segment.index);
            }
        }
    }

    void addCurvature(SegmentElements elements, double segmentsPerTurn, const Progress &progress) {
        addCurvatureSites(domain_, faces_, chains_, elements, segmentsPerTurn, minimum_, gradation_,
                          SpacingOrigin::Automatic, true, progress, sites_);
    }

    /// Adds the sites of corners and lone points, and with `channels` those of narrow places.
    void addGaps(const Box2 &box, bool channels, const Progress &progress) {
        std::vector<PlacedSegment> placed = thingsOf(domain_);
        applyCurveLengths(domain_, chains_, placed);
        const SegmentIndex things(std::move(placed));
        const GapFinder finder(domain_, faces_, things, maximum_, kFinestGap * box.diagonal(), progress);
        std::vector<Gap> gaps = finder.find();
        if (!channels) {
            std::erase_if(gaps, [](const Gap &gap) { return !gap.corner; });
        }
        const double budget = kGapElements + kGapElementsEach * static_cast<double>(domain_.segments.size());
        const double floor = affordableFloor(gaps, maximum_, budget);
        reserve(gaps.size() + domain_.points.size());
        for (const Gap &gap : gaps) {
            const double size = std::max(gap.width / kAcrossGap, floor);
            if (size < 0.95 * std::min(maximum_, gap.wholeLength) && distance(gap.a, gap.b) > 0.0) {
                add(SizeSite::segment(gap.a, gap.b, size, gradation_),
                    gap.corner ? SiteReason::Corner : SiteReason::Channel, gap.segment);
            }
        }
        for (std::uint32_t i = 0; i < things.segments.size(); ++i) {
            const PlacedSegment &thing = things.segments[i];
            if (thing.index >= domain_.segments.size()) {
                const std::uint32_t node = domain_.points[thing.index - domain_.segments.size()].node;
                add(SizeSite::point(thing.a, std::max(finder.clearance(i), floor), gradation_), SiteReason::LonePoint,
                    node);
            }
        }
    }

  private:
    void reserve(std::size_t further) {
        sites_.sites.reserve(sites_.sites.size() + further);
        sites_.labels.reserve(sites_.labels.size() + further);
    }
    void add(const SizeSite &site, SiteReason reason, std::uint32_t index) {
        sites_.add(limited(site, minimum_, gradation_), {SpacingOrigin::Automatic, reason, index});
    }

    const Domain &domain_;
    const LazyFaces &faces_;
    CurveChains chains_;
    double minimum_, maximum_, gradation_;
    SiteSet &sites_;
};

} // namespace

double automaticMaximum(const Box2 &box) {
    return box.diagonal() / kAcross;
}

AutomaticSpacing automaticSpacing(const Domain &domain, const LazyFaces &faces, SegmentElements elements,
                                  const Box2 &box, double minimum, double gradation, double largest,
                                  double segmentsPerTurn, bool channels, const Progress &progress) {
    AutomaticSpacing automatic;
    automatic.maximum = automaticMaximum(box);
    AutomaticSites sites(domain, faces, minimum, std::max(automatic.maximum, largest), gradation, automatic.sites);
    sites.addLengths();
    if (segmentsPerTurn > 0.0) {
        sites.addCurvature(elements, segmentsPerTurn, progress);
    }
    sites.addGaps(box, channels, progress);
    automatic.sites.dropDominated();
    automatic.gradation = sites.gradation();
    return automatic;
}

} // namespace forefront
