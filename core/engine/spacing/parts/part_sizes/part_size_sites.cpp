#include "core/engine/spacing/parts/part_sizes/part_size_sites.hpp"

#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"

namespace forefront {
namespace {

bool hasOwnSize(const std::vector<PartSize> &sizes, std::uint32_t segment) {
    return segment < sizes.size() && sizes[segment].size != 0.0;
}

} // namespace

void addPartSizeSites(const Domain &domain, const std::map<std::int32_t, PartSize> &sizes,
                      const std::vector<PartSize> &ofSegments, double minimum, double gradation, SiteSet &sites) {
    const auto add = [&](const SizeSite &site, std::int32_t tag) {
        sites.add(limited(site, minimum, gradation),
                  {SpacingOrigin::Boundary, SiteReason::PartSize, static_cast<std::uint32_t>(tag)});
    };
    for (const PlacedSegment &segment : placedSegments(domain)) {
        if (hasOwnSize(ofSegments, segment.index)) {
            continue;
        }
        const std::int32_t tag = domain.segments[segment.index].tag;
        if (const auto found = sizes.find(tag); found != sizes.end()) {
            add(SizeSite::segment(segment.a, segment.b, found->second.size, found->second.growth, 0.0), tag);
        }
    }
    for (const ConstraintPoint &point : domain.points) {
        const auto found = sizes.find(point.tag);
        if (found != sizes.end() && point.node < domain.nodes.size() && isUsable(domain.nodes[point.node])) {
            add(SizeSite::point(domain.nodes[point.node], found->second.size, found->second.growth, 0.0), point.tag);
        }
    }
}

void addSegmentSizeSites(const Domain &domain, const std::vector<PartSize> &sizes, double minimum, double gradation,
                         SiteSet &sites) {
    if (sizes.empty()) {
        return;
    }
    for (const PlacedSegment &segment : placedSegments(domain)) {
        if (hasOwnSize(sizes, segment.index)) {
            const auto [size, growth] = sizes[segment.index];
            sites.add(limited(SizeSite::segment(segment.a, segment.b, size, growth, 0.0), minimum, gradation),
                      {SpacingOrigin::Boundary, SiteReason::SegmentSize, segment.index});
        }
    }
}

} // namespace forefront
