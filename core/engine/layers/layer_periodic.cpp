#include "core/engine/layers/layer_periodic.hpp"

#include <algorithm>
#include <cstdint>

namespace forefront {

namespace {

constexpr double kSamePlace = 0.25; ///< distance of an end from the image of another, relative to the segment

/// An end of a chain that slides along a periodic part.
struct PeriodicEnd {
    LayerRay *ray = nullptr;
    std::uint32_t segment = 0; ///< of the domain
    bool matched = false;
};

std::vector<PeriodicEnd> periodicEnds(const PeriodicSides &sides, std::vector<RayChain> &chains) {
    std::vector<PeriodicEnd> ends;
    for (RayChain &chain : chains) {
        for (std::size_t e = 0; !chain.closed && e < 2; ++e) {
            if (const std::uint32_t s = chain.ends[e].slidesAlong; s != kNoIndex && sides.ties(s)) {
                ends.push_back({e == 0 ? &chain.rays.front() : &chain.rays.back(), s});
            }
        }
    }
    return ends;
}

} // namespace

bool matchPeriodicEnds(const PeriodicSides &sides, const Domain &domain, std::vector<RayChain> &chains) {
    if (sides.links.empty()) {
        return false;
    }
    std::vector<PeriodicEnd> ends = periodicEnds(sides, chains);
    bool lowered = false;
    const auto lower = [&](LayerRay &ray, std::uint32_t to, std::uint32_t other) {
        lowered = lowered || ray.count > to;
        ray.lower(to, LayerStop::End, domain.segments[other].tag);
    };
    for (PeriodicEnd &first : ends) {
        const PeriodicMate &mate = sides.mates[first.segment];
        if (mate.follows) {
            continue;
        }
        const Vec2 image = sides.links[mate.link].map(first.ray->base);
        const DomainSegment &along = domain.segments[mate.segment];
        const double reach = kSamePlace * distance(domain.nodes[along.a], domain.nodes[along.b]);
        const auto second = std::ranges::find_if(ends, [&](const PeriodicEnd &end) {
            return end.segment == mate.segment && distance(end.ray->base, image) < reach;
        });
        if (second != ends.end()) {
            const std::uint32_t count = std::min(first.ray->count, second->ray->count);
            lower(*first.ray, count, mate.segment);
            lower(*second->ray, count, first.segment);
            // Where the walls meet the parts at different angles, the lower layers are those of both.
            const double a = length(first.ray->direction), b = length(second->ray->direction);
            first.ray->direction = (std::min(a, b) / a) * first.ray->direction;
            second->ray->direction = (std::min(a, b) / b) * second->ray->direction;
            first.matched = second->matched = true;
        }
    }
    for (const PeriodicEnd &end : ends) {
        if (!end.matched) {
            lower(*end.ray, 0, sides.mates[end.segment].segment);
        }
    }
    return lowered;
}

} // namespace forefront
