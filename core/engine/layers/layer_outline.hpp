#pragma once

#include "core/engine/geometry/plane_sweep.hpp"
#include "core/engine/layers/layer_rays.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace forefront {

/// The ray at the end of a chain that slides along a segment of the domain.
struct SlidingRay {
    std::uint32_t chain = 0;
    std::uint32_t ray = 0;
    std::uint32_t node = 0; ///< of the boundary, where it starts
};

/// The rays that slide along straight segments of the domain, and have layers: at most one from each end. By index of
/// the segment.
std::map<std::uint32_t, std::vector<SlidingRay>> slidingRays(std::span<const RayChain> chains);

/// The top edge of a column of layers.
struct TopEdge {
    std::uint32_t chain = 0;
    std::uint32_t column = 0;
};

/// The boundary of what the layers leave free: the tops of the columns, and the segments that carry none.
struct LayerOutline {
    std::vector<Vec2> points;
    std::vector<PlaneEdge> edges;   ///< the tops first
    std::vector<TopEdge> tops;      ///< as many as the first edges
    std::vector<std::int32_t> tags; ///< per edge: of the boundary part it lies on or over
};

/// Marks the sides of segments that columns of layers cover: per segment, bit 0 for its left side, bit 1 for its right.
std::vector<std::uint8_t> coveredSides(const DiscreteDomain &boundary, std::span<const RayChain> chains);

/// Returns the outline of the layers as they are now. Segments along which rays slide are one edge between their tops.
LayerOutline outlineOf(const DiscreteDomain &boundary, std::span<const RayChain> chains,
                       std::span<const LayerHeights> heights);

/// Returns true if the segment still bounds what the layers leave free.
inline bool isExposed(const DiscreteSegment &s, std::uint8_t covered) {
    return (s.leftRegion != kOutside && (covered & 1U) == 0) || (s.rightRegion != kOutside && (covered & 2U) == 0);
}

/// Returns true if a column has layers, so that its top is an edge; a fan without layers has none.
inline bool hasLayers(const RayChain &chain, std::size_t column) {
    return chain.rays[column].count > 0 || chain.rayAfter(column).count > 0;
}

} // namespace forefront
