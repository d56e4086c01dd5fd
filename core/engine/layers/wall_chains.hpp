#pragma once

#include "core/engine/base/ids.hpp"
#include "core/engine/boundary/discretise.hpp"
#include "core/engine/layers/layer_spec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// An edge of the discretised boundary that carries layers, from a to b with the layers on its left.
struct WallEdge {
    std::uint32_t a = 0; ///< index into DiscreteDomain::nodes
    std::uint32_t b = 0;
    std::uint32_t segment = 0; ///< index into DiscreteDomain::segments
    std::uint32_t face = 0;    ///< index into DiscreteDomain::regions
    std::uint32_t spec = 0;    ///< index of its LayerSpec
};

/// An edge of the boundary next to the end of a chain, seen from there.
struct ChainNeighbour {
    std::uint32_t segment = kNoIndex; ///< index into DiscreteDomain::segments; kNoIndex: the chain is closed
    std::uint32_t far = kNoIndex;     ///< its other node
};

/// Successive wall edges along the boundary of one face.
struct WallChain {
    std::vector<WallEdge> edges;
    bool closed = false;
    ChainNeighbour before; ///< at the first node of an open chain
    ChainNeighbour after;  ///< at its last node
};

/// Returns the chains of all edges with a tag of `specs`; an edge inside the domain is in one for each of its sides.
std::vector<WallChain> wallChains(const DiscreteDomain &boundary, std::span<const LayerSpec> specs);

} // namespace forefront
