#include "core/engine/layers/layer_outline.hpp"

#include <algorithm>

namespace forefront {

std::map<std::uint32_t, std::vector<SlidingRay>> slidingRays(std::span<const RayChain> chains) {
    std::map<std::uint32_t, std::vector<SlidingRay>> rays;
    for (std::uint32_t c = 0; c < chains.size(); ++c) {
        const RayChain &chain = chains[c];
        for (std::size_t e = 0; !chain.closed && e < 2; ++e) {
            const auto number = static_cast<std::uint32_t>(e == 0 ? 0 : chain.rays.size() - 1);
            const LayerRay &ray = chain.rays[number];
            if (chain.ends[e].slidesAlong != kNoIndex && ray.count > 0) {
                rays[chain.ends[e].slidesAlong].push_back({c, number, ray.node});
            }
        }
    }
    return rays;
}

std::vector<std::uint8_t> coveredSides(const DiscreteDomain &boundary, std::span<const RayChain> chains) {
    std::vector<std::uint8_t> covered(boundary.segments.size(), 0);
    for (const RayChain &chain : chains) {
        for (std::size_t i = 0; i < chain.columns.size(); ++i) {
            const WallEdge &edge = chain.columns[i];
            if (!RayChain::isFan(edge) && hasLayers(chain, i)) {
                const unsigned side = boundary.segments[edge.segment].a == edge.a ? 1U : 2U;
                covered[edge.segment] = static_cast<std::uint8_t>(covered[edge.segment] | side);
            }
        }
    }
    return covered;
}

LayerOutline outlineOf(const DiscreteDomain &boundary, std::span<const RayChain> chains,
                       std::span<const LayerHeights> heights) {
    LayerOutline outline;
    outline.points = boundary.nodes;
    const auto top = [&](const LayerRay &ray) {
        if (ray.count == 0) {
            return ray.node;
        }
        outline.points.push_back(placeOn(ray, ray.count, heights));
        return static_cast<std::uint32_t>(outline.points.size() - 1);
    };
    std::vector<std::vector<std::uint32_t>> ids(chains.size());
    for (std::uint32_t c = 0; c < chains.size(); ++c) {
        const RayChain &chain = chains[c];
        for (const LayerRay &ray : chain.rays) {
            ids[c].push_back(top(ray));
        }
        for (std::uint32_t i = 0; i < chain.columns.size(); ++i) {
            if (hasLayers(chain, i)) {
                outline.edges.push_back({ids[c][i], ids[c][i + 1 < chain.rays.size() ? i + 1 : 0]});
                outline.tops.push_back({c, i});
                outline.tags.push_back(boundary.segments[chain.columns[i].segment].tag);
            }
        }
    }
    const auto sliding = slidingRays(chains);
    const std::vector<std::uint8_t> covered = coveredSides(boundary, chains);
    for (std::size_t s = 0; s < boundary.segments.size(); ++s) {
        const DiscreteSegment &segment = boundary.segments[s];
        if (!isExposed(segment, covered[s])) {
            continue;
        }
        PlaneEdge edge{segment.a, segment.b};
        if (const auto slid = sliding.find(segment.source); slid != sliding.end()) {
            // The parts beyond the tops; a part below a top shrinks to a point there.
            for (const SlidingRay &ray : slid->second) {
                const std::uint32_t id = ids[ray.chain][ray.ray];
                const Vec2 base = boundary.nodes[ray.node];
                const double reach = distance(base, outline.points[id]);
                for (std::uint32_t *const end : {&edge.a, &edge.b}) {
                    if (*end < boundary.nodes.size() && distance(base, boundary.nodes[*end]) < reach) {
                        *end = id;
                    }
                }
            }
            if (edge.a == edge.b) {
                continue;
            }
        }
        outline.edges.push_back(edge);
        outline.tags.push_back(segment.tag);
    }
    return outline;
}

} // namespace forefront
