#pragma once

#include "core/domain/domain.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace forefront {

/// Nodes on the boundary that are close to another feature without touching it, such as along the border of two
/// districts that have been digitised twice.
struct FeatureGaps {
    std::size_t count = 0;   ///< of nodes
    double widest = 0.0;     ///< of their distances
    Vec2 first;              ///< the first of the nodes
    std::size_t segment = 0; ///< a segment at that node
};

/// Finds the nodes that are within `limit` of another feature, but no nearer than that to the next node where features
/// meet: beside it, gaps end. `features`: per domain segment, the feature that it bounds; kNoIndex: unknown. O(n log
/// n).
FeatureGaps findFeatureGaps(const Domain &domain, std::span<const std::uint32_t> features, double limit);

} // namespace forefront
