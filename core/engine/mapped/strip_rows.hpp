#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/layers/boundary_layers.hpp"
#include "core/engine/strips/widened_domain.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace forefront {

class RowGrid;

/// The edges around a face, each from one node to the next: counter-clockwise, with the face on the left.
using NextNodes = std::map<std::uint32_t, std::uint32_t>;

/// The nodes of a strip on its outline, as the boundary divides it.
struct StripOutline {
    std::vector<std::uint32_t> left, right; ///< along the strip; of a closed one, the first node is the last, too
    std::vector<std::uint32_t> first, last; ///< across it, from right to left; empty where it is closed

    /// Returns the nodes counter-clockwise around the strip; a closed one is cut open at its first nodes.
    std::vector<std::uint32_t> around() const;
};

/// Follows the outline of a strip. `next`: of its face. Error: mapped-sides (the sides, or the ends, have different
/// numbers of edges).
Result<StripOutline> stripOutline(const StripFace &strip, const Domain &domain, const DiscreteDomain &boundary,
                                  const NextNodes &next);

/// Fills a strip: adds its inner nodes and its elements to `rows`. Errors: mapped-inverted, cancelled.
Status fillStrip(const StripFace &strip, const StripOutline &outline, const DiscreteDomain &boundary,
                 BoundaryLayers &rows, const Progress &progress);

/// Adds the elements of a grid of nodes to `rows`. `ids`: of the nodes, (along + 1) by (across + 1).
void addRowCells(const RowGrid &grid, const std::vector<std::uint32_t> &ids, bool quads, std::uint32_t region,
                 BoundaryLayers &rows);

} // namespace forefront
