#include "core/engine/pipeline/periodic_sites.hpp"

namespace forefront {

std::vector<SizeSite> periodicSites(const DiscreteDomain &boundary, const PeriodicSides &sides,
                                    const SpacingField &spacing, double gradation) {
    constexpr double kClearlyShorter = 0.8; // whole numbers of edges leave some shorter than the spacing
    std::vector<SizeSite> sites;
    for (const DiscreteSegment &segment : boundary.segments) {
        if (!sides.ties(segment.source)) {
            continue;
        }
        const Vec2 a = boundary.nodes[segment.a], b = boundary.nodes[segment.b];
        const double length = distance(a, b);
        if (length > 0.0 && length < kClearlyShorter * spacing.at(midpoint(a, b))) {
            sites.push_back(SizeSite::segment(a, b, length, gradation));
        }
    }
    return sites;
}

} // namespace forefront
