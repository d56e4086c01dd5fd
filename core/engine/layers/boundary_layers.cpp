#include "core/engine/layers/boundary_layers.hpp"

#include "core/engine/boundary/estimate.hpp"
#include "core/engine/layers/finished_rays.hpp"
#include "core/engine/layers/layer_cut.hpp"
#include "core/engine/layers/layer_elements.hpp"
#include "core/engine/layers/layer_rays.hpp"
#include "core/engine/layers/layered_field.hpp"

#include <utility>

namespace forefront {

namespace {

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
    Result<FinishedRays> finished = finishedRays(request, *boundary, progress);
    if (!finished) {
        return finished.faults();
    }
    std::vector<RayChain> &chains = finished->chains;
    const std::vector<LayerHeights> &heights = finished->heights;
    Result<std::shared_ptr<const SpacingField>> field =
        layeredField(std::move(spacing), topSites(chains, heights, request.gradation), boundary->bounds(), progress);
    if (!field) {
        return field.faults();
    }
    Result<CutBoundary> cut = cutWhereSliding(*boundary, heights, **field, request.periodic, chains, progress);
    if (!cut) {
        return cut.faults();
    }
    BoundaryLayers layers = layerElements(*cut, *finished, request.specs);
    const auto count = static_cast<double>(layers.cells.size());
    cut->domain.estimatedElements = count + estimateElements(*layers.outer, **field);
    return BuiltLayers{std::make_shared<const BoundaryLayers>(std::move(layers)),
                       std::make_shared<const DiscreteDomain>(std::move(cut->domain)), std::move(*field)};
}

} // namespace forefront
