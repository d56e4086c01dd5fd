#include "core/engine/spacing/parts/automatic/boundary_spacing.hpp"

#include "core/engine/base/ids.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace forefront {

bool isUsable(Vec2 p) {
    return isFinite(p) && std::fabs(p.x) < 1e150 && std::fabs(p.y) < 1e150;
}

std::vector<PlacedSegment> placedSegments(const Domain &domain) {
    std::vector<PlacedSegment> placed;
    placed.reserve(domain.segments.size());
    for (std::size_t i = 0; i < domain.segments.size(); ++i) {
        const DomainSegment &segment = domain.segments[i];
        if (segment.a >= domain.nodes.size() || segment.b >= domain.nodes.size()) {
            continue;
        }
        PlacedSegment candidate{domain.nodes[segment.a], domain.nodes[segment.b], static_cast<std::uint32_t>(i)};
        candidate.wholeLength = candidate.length();
        if (isUsable(candidate.a) && isUsable(candidate.b) && candidate.wholeLength > 0.0) {
            placed.push_back(candidate);
        }
    }
    return placed;
}

void applyCurveLengths(const Domain &domain, const CurveChains &chains, std::vector<PlacedSegment> &segments) {
    if (chains.list.empty()) {
        return;
    }
    std::vector<double> lengths;
    std::vector<std::uint8_t> isEnd(domain.nodes.size(), 0);
    for (const CurveChain &chain : chains.list) {
        lengths.push_back(domain.curves[chain.curve].length(chain.t0, chain.t1));
        isEnd[chain.start] = isEnd[chain.end] = 1;
    }
    for (PlacedSegment &segment : segments) {
        if (segment.index >= domain.segments.size()) {
            continue; // a lone point
        }
        const DomainSegment &ends = domain.segments[segment.index];
        const std::uint32_t chain = chains.ofSegment[segment.index];
        segment.besideCurve = chain != kNoIndex || isEnd[ends.a] != 0 || isEnd[ends.b] != 0;
        if (chain != kNoIndex) {
            segment.wholeLength = std::max(segment.wholeLength, lengths[chain]);
        }
    }
}

Box2 spacingBox(const Domain &domain) {
    Box2 box;
    for (const Vec2 node : domain.nodes) {
        if (isUsable(node)) {
            box.add(node);
        }
    }
    if (box.empty()) {
        return {{0.0, 0.0}, {1.0, 1.0}};
    }
    const double extent = std::max(box.size().x, box.size().y);
    const double offset =
        std::max({std::fabs(box.min.x), std::fabs(box.max.x), std::fabs(box.min.y), std::fabs(box.max.y), 1e-140});
    return extent > 0.0 ? box : box.grown(offset * 1e-3);
}

void dropDominated(const Domain &domain, double gradation, std::vector<PlacedSegment> &segments) {
    std::vector<double> shortest(domain.nodes.size(), std::numeric_limits<double>::infinity());
    const auto ends = [&](const PlacedSegment &segment) { return domain.segments[segment.index]; };
    for (const PlacedSegment &segment : segments) {
        for (const std::uint32_t node : {ends(segment).a, ends(segment).b}) {
            shortest[node] = std::min(shortest[node], segment.wholeLength);
        }
    }
    std::erase_if(segments, [&](const PlacedSegment &segment) {
        const double length = segment.wholeLength;
        const auto neighbour = [&](std::uint32_t node) {
            return shortest[node] < length ? shortest[node] : std::numeric_limits<double>::infinity();
        };
        const double a = neighbour(ends(segment).a);
        const double b = neighbour(ends(segment).b);
        // The sizes that both neighbours allow grow along the segment; the maximum is where they meet.
        const double growth = gradation * length;
        const double highest = std::fabs(a - b) <= growth ? 0.5 * (a + b + growth) : std::min(a, b) + growth;
        return highest <= length; // false where neither end has a shorter neighbour
    });
}

void addBoundarySites(const Domain &domain, double minimum, double gradation, SiteSet &sites) {
    std::vector<PlacedSegment> segments = placedSegments(domain);
    dropDominated(domain, gradation, segments);
    for (const PlacedSegment &segment : segments) {
        sites.add(limited(SizeSite::segment(segment.a, segment.b, segment.length(), gradation), minimum, gradation),
                  {SpacingOrigin::Boundary, SiteReason::SegmentLength, segment.index});
    }
}

} // namespace forefront
