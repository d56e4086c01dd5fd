#include "core/engine/layers/finished_rays.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/layers/layer_limits.hpp"
#include "core/engine/layers/layer_periodic.hpp"
#include "core/engine/layers/layer_repair.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace forefront {

namespace {

std::vector<LayerHeights> heightsOf(const DiscreteDomain &boundary, const std::vector<WallChain> &walls,
                                    std::span<const LayerSpec> specs) {
    std::vector<double> longest(specs.size(), 0.0);
    for (const WallChain &wall : walls) {
        for (const WallEdge &edge : wall.edges) {
            longest[edge.spec] = std::max(longest[edge.spec], distance(boundary.nodes[edge.a], boundary.nodes[edge.b]));
        }
    }
    std::vector<LayerHeights> heights;
    for (std::size_t i = 0; i < specs.size(); ++i) {
        heights.emplace_back(specs[i], longest[i]);
    }
    return heights;
}

/// Returns the number of elements that the layers of some rays have, quadrilaterals divided as asked; a step between
/// two rays counts as a whole layer.
double elementsOf(std::span<const RayChain> chains, std::span<const LayerSpec> specs) {
    double count = 0.0;
    for (const RayChain &chain : chains) {
        for (std::size_t i = 0; i < chain.columns.size(); ++i) {
            const double layers = std::max(chain.rays[i].count, chain.rayAfter(i).count);
            count += specs[chain.rays[i].spec].cells == LayerCells::Triangles ? 2.0 * layers : layers;
        }
    }
    return count;
}

} // namespace

Result<FinishedRays> finishedRays(const LayerRequest &request, const DiscreteDomain &boundary,
                                  const Progress &progress) {
    const std::vector<WallChain> walls = wallChains(boundary, request.specs);
    FinishedRays rays{{}, heightsOf(boundary, walls, request.specs)};
    std::vector<RayChain> &chains = rays.chains;
    const std::span<const LayerHeights> heights = rays.heights;
    for (const WallChain &wall : walls) {
        if (progress.cancelled()) {
            return cancelled("meshing");
        }
        RayChain chain =
            raysOf(boundary, wall, heights, request.specs, {&request.domain, request.elements, request.keepBoundary});
        levelLayers(chain);
        for (LayerRay &ray : chain.rays) {
            ray.asked = ray.count; // longer wall edges beside shorter ones
        }
        chains.push_back(std::move(chain));
    }
    limitAtEnds(request.domain, boundary, heights, chains);
    if (!limitByObstacles(boundary, heights, request.specs, chains, progress)) {
        return cancelled("meshing");
    }
    const auto level = [&] { std::ranges::for_each(chains, levelLayers); };
    const auto match = [&] {
        return request.periodic != nullptr && matchPeriodicEnds(*request.periodic, request.domain, chains);
    };
    do {
        level();
    } while (match());
    if (const double count = elementsOf(chains, request.specs); count > request.maxElements) {
        return error("too-many-elements",
                     "the boundary layers need about " + numberText(count, 3) + " elements; expected at most " +
                         numberText(request.maxElements, 3),
                     "ask for fewer layers or longer wall edges, or raise the maximum number of elements");
    }
    do {
        level();
        if (!repairLayers(boundary, heights, chains, progress)) {
            return cancelled("meshing");
        }
    } while (match());
    return rays;
}

LayerReport reportOf(const FinishedRays &rays, const DiscreteDomain &boundary) {
    LayerReport report;
    report.fewest = std::numeric_limits<std::uint32_t>::max();
    for (const RayChain &chain : rays.chains) {
        std::uint32_t fans = 0;
        for (std::size_t i = 0; i < chain.rays.size(); ++i) {
            const LayerRay &ray = chain.rays[i];
            ++report.rays;
            fans = ray.fan == kNoIndex ? fans : std::max(fans, ray.fan + 1);
            report.fewest = std::min(report.fewest, ray.count);
            report.most = std::max(report.most, ray.count);
            report.lines.push_back({ray.base, placeOn(ray, ray.count, rays.heights), ray.count});
            if (ray.count < ray.asked) {
                const WallEdge &edge = chain.columns[std::min(i, chain.columns.size() - 1)];
                report.shortened.push_back({ray.base, placeOn(ray, ray.count, rays.heights),
                                            boundary.segments[edge.segment].tag, ray.asked, ray.count, ray.stop,
                                            ray.stoppedBy});
            }
        }
        report.fans += fans;
    }
    report.fewest = report.rays > 0 ? report.fewest : 0;
    return report;
}

} // namespace forefront
