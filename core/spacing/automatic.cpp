#include "core/spacing/automatic.hpp"

#include "core/spacing/boundary_spacing.hpp"

namespace forefront {
namespace {

constexpr double kAcross = 30.0; ///< elements along the diagonal of the domain's box

} // namespace

AutomaticSpacing automaticSpacing(const Domain &domain, const Box2 &box, double minimum, double gradation,
                                  const Progress &) {
    AutomaticSpacing automatic;
    automatic.greatest = box.diagonal() / kAcross;
    std::vector<PlacedSegment> segments = placedSegments(domain);
    dropDominated(domain, gradation, segments);
    for (const PlacedSegment &segment : segments) {
        const double length = segment.length();
        if (length < automatic.greatest) {
            automatic.sites.add(limited(SizeSite::segment(segment.a, segment.b, length, gradation), minimum, gradation),
                                {SpacingOrigin::Automatic, SiteReason::SegmentLength, segment.index});
        }
    }
    return automatic;
}

} // namespace forefront
