#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <initializer_list>
#include <span>

namespace FOREFRONT_API forefront {

/// The nodes and segments of a loop in a domain: `count` of each. Segment k of the loop leads from its node k to the
/// next one.
struct LoopRange {
    std::uint32_t firstNode = 0;    ///< index into Domain::nodes
    std::uint32_t firstSegment = 0; ///< index into Domain::segments
    std::uint32_t count = 0;
    std::int32_t tag = 1; ///< of the segments
};

/// Adds a closed polygon, nodes and boundary segments, and returns where they are. Its orientation does not matter; a
/// loop inside another loop is a hole.
inline LoopRange addLoop(Domain &domain, std::span<const Vec2> nodes, std::int32_t tag = 1) {
    const LoopRange loop{static_cast<std::uint32_t>(domain.nodes.size()),
                         static_cast<std::uint32_t>(domain.segments.size()), static_cast<std::uint32_t>(nodes.size()),
                         tag};
    domain.nodes.insert(domain.nodes.end(), nodes.begin(), nodes.end());
    for (std::uint32_t i = 0; i < loop.count; ++i) {
        domain.segments.push_back(
            {loop.firstNode + i, loop.firstNode + (i + 1) % loop.count, tag, SegmentRole::Boundary});
    }
    return loop;
}
/// Adds a polygon whose corners are listed in braces, such as addLoop(domain, {{0, 0}, {4, 0}, {4, 3}}).
inline LoopRange addLoop(Domain &domain, std::initializer_list<Vec2> nodes, std::int32_t tag = 1) {
    return addLoop(domain, std::span<const Vec2>(nodes.begin(), nodes.size()), tag);
}

} // namespace forefront
