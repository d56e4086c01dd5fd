#include "core/engine/layers/layer_rows.hpp"

#include "core/engine/layers/finished_rays.hpp"

#include <algorithm>
#include <cstdint>

namespace forefront {

namespace {

std::size_t piecesOf(const FinishedRays &rays) {
    std::size_t count = 0;
    for (const RayChain &chain : rays.chains) {
        for (std::size_t i = 0; i < chain.columns.size(); ++i) {
            count += std::max(chain.rays[i].count, chain.rayAfter(i).count);
        }
    }
    return count;
}

/// Adds the pieces of the rows between two rays, from the first row on, or the top alone.
void addColumn(const LayerRay &p, const LayerRay &q, const FinishedRays &rays, bool topAlone, LayerRows &rows) {
    const std::uint32_t both = std::min(p.count, q.count), last = std::max(p.count, q.count);
    const auto add = [&](std::uint32_t atP, std::uint32_t atQ) {
        rows.pieces.push_back({placeOn(p, atP, rays.heights), placeOn(q, atQ, rays.heights)});
    };
    for (std::uint32_t k = 1; k <= both && !topAlone; ++k) {
        add(k, k);
    }
    if (last > 0 && (topAlone || last > both)) {
        add(p.count, q.count);
    }
}

} // namespace

Result<LayerRows> layerRows(const LayerRequest &request, const DiscreteDomain &boundary, const Progress &progress) {
    const Result<FinishedRays> rays = finishedRays(request, boundary, progress);
    if (!rays) {
        return rays.faults();
    }
    LayerRows rows{reportOf(*rays, boundary), {}};
    const bool topsAlone = piecesOf(*rays) > LayerRows::kMaxPieces;
    for (const RayChain &chain : rays->chains) {
        for (std::size_t i = 0; i < chain.columns.size(); ++i) {
            addColumn(chain.rays[i], chain.rayAfter(i), *rays, topsAlone, rows);
        }
    }
    return rows;
}

} // namespace forefront
