#include "core/engine/spacing/parts/automatic/gap_sites.hpp"

#include "core/engine/spacing/parts/automatic/gap_finder.hpp"

#include <utility>

namespace forefront {

void addGapSites(const Domain &domain, const LazyFaces &faces, double across, double longest, double minimum,
                 double gradation, const Progress &progress, SiteSet &sites) {
    const CurveChains chains = curveChains(domain);
    std::vector<PlacedSegment> placed = placedSegments(domain); // points are no walls
    applyCurveLengths(domain, chains, placed);
    const SegmentIndex index(std::move(placed));
    const double finest = kFinestGap * spacingBox(domain).diagonal();
    const GapFinder finder(domain, faces, index, longest, finest, progress, {.across = across, .everywhere = true});
    for (const Gap &gap : finder.find()) {
        // The size holds up to the middle of the gap, so that it does not grow between the sides.
        const SizeSite site = SizeSite::segment(gap.a, gap.b, gap.width / across, gradation, 0.5 * gap.width);
        sites.add(limited(site, minimum, gradation),
                  {SpacingOrigin::Boundary, gap.corner ? SiteReason::Corner : SiteReason::Channel, gap.segment});
    }
}

} // namespace forefront
