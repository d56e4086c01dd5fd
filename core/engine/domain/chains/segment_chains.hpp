#pragma once

#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <vector>

namespace forefront {

/// A chain of consecutive segments: segment k joins nodes k and k + 1; the last of a closed chain leads back to the
/// first node, which is not repeated.
struct SegmentChain {
    std::vector<std::uint32_t> nodes;
    std::vector<std::uint32_t> segments;
    bool closed = false;
};

/// Chains the segments of one role: a chain continues through every node where exactly two of them meet. Open chains
/// come first (from ends and junctions), then loops, both in the order of their first segments, where they also begin.
/// Segments with a node out of range are left out; the numbers of nodes have no influence.
std::vector<SegmentChain> segmentChains(const Domain &domain, SegmentRole role);

} // namespace forefront
