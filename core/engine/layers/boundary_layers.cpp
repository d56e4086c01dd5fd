#include "core/engine/layers/boundary_layers.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/boundary/estimate.hpp"
#include "core/engine/layers/layer_cut.hpp"
#include "core/engine/layers/layer_elements.hpp"
#include "core/engine/layers/layer_limits.hpp"
#include "core/engine/layers/layer_periodic.hpp"
#include "core/engine/layers/layer_rays.hpp"
#include "core/engine/layers/layer_repair.hpp"
#include "core/engine/layers/layered_field.hpp"

#include <algorithm>
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

/// Returns the rays with the numbers of layers that they can have.
Result<std::vector<RayChain>> finishedRays(const LayerRequest &request, const DiscreteDomain &boundary,
                                           const std::vector<WallChain> &walls, std::span<const LayerHeights> heights,
                                           const Progress &progress) {
    std::vector<RayChain> chains;
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
    return chains;
}

std::vector<SizeSite> topSites(std::span<const RayChain> chains, std::span<const LayerHeights> heights, double growth) {
    std::vector<SizeSite> sites;
    for (const RayChain &chain : chains) {
        for (std::size_t i = 0; i < chain.columns.size(); ++i) {
            const LayerRay &p = chain.rays[i], &q = chain.rayAfter(i);
            const Vec2 a = placeOn(p, p.count, heights), b = placeOn(q, q.count, heights);
            if (const double size = distance(a, b); size > 0.0 && (p.count > 0 || q.count > 0)) {
                sites.push_back(SizeSite::segment(a, b, size, growth));
            }
        }
    }
    return sites;
}

} // namespace

Result<BuiltLayers> buildLayers(const LayerRequest &request, std::shared_ptr<const DiscreteDomain> boundary,
                                std::shared_ptr<const SpacingField> spacing, const Progress &progress) {
    progress("building boundary layers", 0.0);
    const std::vector<WallChain> walls = wallChains(*boundary, request.specs);
    const std::vector<LayerHeights> heights = heightsOf(*boundary, walls, request.specs);
    Result<std::vector<RayChain>> finished = finishedRays(request, *boundary, walls, heights, progress);
    if (!finished) {
        return finished.faults();
    }
    std::vector<RayChain> &chains = *finished;
    Result<std::shared_ptr<const SpacingField>> field =
        layeredField(std::move(spacing), topSites(chains, heights, request.gradation), boundary->bounds(), progress);
    if (!field) {
        return field.faults();
    }
    Result<CutBoundary> cut = cutWhereSliding(*boundary, heights, **field, request.periodic, chains, progress);
    if (!cut) {
        return cut.faults();
    }
    BoundaryLayers layers = layerElements(*cut, chains, heights, request.specs);
    const auto count = static_cast<double>(layers.cells.size());
    cut->domain.estimatedElements = count + estimateElements(*layers.outer, **field);
    return BuiltLayers{std::make_shared<const BoundaryLayers>(std::move(layers)),
                       std::make_shared<const DiscreteDomain>(std::move(cut->domain)), std::move(*field)};
}

} // namespace forefront
