#include "core/engine/spacing/parts/part_sizes/part_size_sites.hpp"

#include "core/engine/domain/element_places.hpp"
#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"

#include <algorithm>
#include <utility>

namespace forefront {
namespace {

bool hasOwnSize(const std::vector<PartSize> &sizes, std::uint32_t segment) {
    return segment < sizes.size() && sizes[segment].size != 0.0;
}

/// Returns the fractions of the length of its line or curve between which a segment lies.
std::pair<double, double> stretchOfSegment(const Domain &domain, std::uint32_t segment) {
    const CurveStretch &stretch = domain.segments[segment].stretch;
    if (!stretch.follows()) {
        return {0.0, 1.0};
    }
    const Curve &curve = domain.curves[stretch.curve];
    const double whole = curve.length();
    const double from = curve.length(0.0, stretch.t0) / whole, to = curve.length(0.0, stretch.t1) / whole;
    return from <= to ? std::pair(from, to) : std::pair(1.0 - from, 1.0 - to);
}

/// Returns the sites of a segment: one of its size, or several with the lengths of the elements along it, if these have
/// a bias.
std::vector<SizeSite> biasedSites(const Domain &domain, const PlacedSizes &placed, const PlacedSegment &segment,
                                  const PartSize &size) {
    constexpr std::uint32_t kMaxSites = 256;
    const ElementBias bias = placed.counts().bias(segment.index);
    const std::uint32_t count = placed.counts()[segment.index];
    if (!bias.any() || count < 2 || !bias.isValid()) {
        return {SizeSite::segment(segment.a, segment.b, size.size, size.growth, 0.0)};
    }
    const std::vector<double> places = elementPlaces(count, bias);
    const auto [from, to] = stretchOfSegment(domain, segment.index);
    const double whole = count * size.size; // length of the line or curve
    const std::uint32_t step = std::max(1U, count / kMaxSites);
    std::vector<SizeSite> sites;
    for (std::uint32_t k = 0; k < count; k += step) {
        const std::uint32_t next = std::min(count, k + step);
        const double low = std::max(places[k], from), high = std::min(places[next], to);
        if (low < high) {
            const auto at = [&, first = from, last = to](double place) {
                return lerp(segment.a, segment.b, (place - first) / (last - first));
            };
            const double length = whole * (places[next] - places[k]) / (next - k);
            sites.push_back(SizeSite::segment(at(low), at(high), length, size.growth, 0.0));
        }
    }
    return sites;
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

void addSegmentSizeSites(const Domain &domain, const PlacedSizes &placed, double minimum, double gradation,
                         SiteSet &sites) {
    const std::vector<PartSize> &sizes = placed.segments;
    if (sizes.empty()) {
        return;
    }
    for (const PlacedSegment &segment : placedSegments(domain)) {
        if (!hasOwnSize(sizes, segment.index)) {
            continue;
        }
        const auto [size, growth] = sizes[segment.index];
        const SiteLabel label{SpacingOrigin::Boundary, SiteReason::SegmentSize, segment.index};
        for (const SizeSite &site : biasedSites(domain, placed, segment, {size, growth})) {
            sites.add(limited(site, minimum, gradation), label);
        }
    }
}

} // namespace forefront
