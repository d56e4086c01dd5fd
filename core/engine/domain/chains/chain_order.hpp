#pragma once

#include "core/engine/domain/chains/chain_path.hpp"
#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// Where the parts of a domain in the order of chains come from: for each node, segment and constraint point, the
/// number of the one in the given domain.
struct ChainOrder {
    std::vector<std::uint32_t> nodes, segments, points;
};

/// Returns the domain with its segments and nodes in the order of chains: boundary chains first, then constraint
/// chains, each along its path (see segmentChains() and ChainPaths), then points. Drawings and maps are read so that
/// they mesh the same from their file and from the document that shows them.
///
/// Each path gets a curve of its own where the given segments share one; the curve is moved to end at its nodes. Nodes
/// at one place become one. Segments and points with a node out of range are left out; a node that nothing refers to
/// stays, at the end. What depends on the order of the given segments: the order of the chains, and where each one
/// starts and runs to. The numbers of the nodes have no influence, except on the order of those that nothing refers to.
///
/// Fills in `order` where it is given. The first form chooses the ends by bestLooseEnds().
Domain inChainOrder(const Domain &domain, ChainOrder *order = nullptr);
Domain inChainOrder(const Domain &domain, LooseEnds ends, ChainOrder *order = nullptr);

/// Returns LooseEnds::MoveCurve unless that would add a fault to the domain: curves that are moved to end at their
/// nodes may cross others nearby, or leave a region's marker.
LooseEnds bestLooseEnds(const Domain &domain);

} // namespace forefront
