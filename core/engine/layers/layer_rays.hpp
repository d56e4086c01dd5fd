#pragma once

#include "core/engine/layers/layer_heights.hpp"
#include "core/engine/layers/layer_report.hpp"
#include "core/engine/layers/wall_chains.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// A straight line from a node of a wall, on which the nodes of its layers lie.
struct LayerRay {
    Vec2 base;
    Vec2 direction;                   ///< the node at height y is at base + y·direction; longer than 1 where it leans
    std::uint32_t node = 0;           ///< of the wall
    std::uint32_t spec = 0;           ///< index of the LayerSpec that its heights follow
    std::uint32_t fan = kNoIndex;     ///< number of the fan it belongs to, counted along its chain; kNoIndex: none
    std::uint32_t asked = 0;          ///< number of layers asked for
    std::uint32_t count = 0;          ///< number of layers that it has
    LayerStop stop = LayerStop::Wall; ///< why there are fewer than asked for
    std::int32_t stoppedBy = 0;       ///< the tag of the part that stopped it
    /// Of a ray that slides along the boundary, once that is cut: the node of its first layer there, which those of the
    /// others follow.
    std::uint32_t slidNode = kNoIndex;

    /// Lowers the number of layers, if it is higher.
    void lower(std::uint32_t to, LayerStop why, std::int32_t tag) {
        if (count > to) {
            count = to;
            stop = why;
            stoppedBy = tag;
        }
    }
};

/// The end of a chain beside a boundary part without layers.
struct LayerEnd {
    ChainNeighbour neighbour;
    /// The straight segment of the domain along which the last ray slides, by index; kNoIndex: it has no layers.
    std::uint32_t slidesAlong = kNoIndex;
};

/// The rays of a chain, in order, and the columns of elements between them: column i lies between the rays i and i + 1,
/// in a closed chain the last one between the last and the first.
struct RayChain {
    std::vector<LayerRay> rays;
    std::vector<WallEdge> columns; ///< the wall edge below each; in a fan, a and b are the same node
    bool closed = false;
    std::array<LayerEnd, 2> ends; ///< of an open chain: at its first and at its last ray

    LayerRay &rayAfter(std::size_t column) { return rays[column + 1 < rays.size() ? column + 1 : 0]; }
    const LayerRay &rayAfter(std::size_t column) const { return rays[column + 1 < rays.size() ? column + 1 : 0]; }
    static bool isFan(const WallEdge &column) { return column.a == column.b; }
};

/// Which segments of the domain may receive nodes of layers.
struct SlidingRules {
    const Domain *domain = nullptr;
    SegmentElements elements;  ///< segments with a number of elements keep it
    bool keepBoundary = false; ///< no segment may be divided in another way
};

/// Returns the rays of a chain with the number of layers asked for. `heights`: by specification.
///
/// At smooth nodes a ray bisects the angle of the wall, and is longer by 1/cos of half the turn, so that the layers
/// stay parallel to both edges. At convex corners of more than 60 degrees there is a fan of rays, 20 degrees apart at
/// most. Beside all other corners of more than 20 degrees, and where an end slides along a straight neighbour at 45 to
/// 135 degrees, the rays lean over gradually, so that they do not meet.
RayChain raysOf(const DiscreteDomain &boundary, const WallChain &chain, std::span<const LayerHeights> heights,
                std::span<const LayerSpec> specs, const SlidingRules &sliding);

/// Returns the place of a node of a ray, counted from the wall.
inline Vec2 placeOn(const LayerRay &ray, std::uint32_t k, std::span<const LayerHeights> heights) {
    return k == 0 ? ray.base : ray.base + heights[ray.spec][k] * ray.direction;
}

} // namespace forefront
