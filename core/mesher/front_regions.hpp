#pragma once

#include "core/geometry/vec2.hpp"

#include <cstddef>
#include <vector>

namespace forefront {

/// The parts of the plane in which the fast method advances one after the other, or at once on several threads: in each
/// it takes only bases whose whole search stays inside. Regions of one phase do not overlap, so their advances do not
/// depend on each other; the last region is the whole plane. They follow from the domain and the spacing alone, never
/// from the number of threads.
struct FrontRegions {
    std::vector<Box2> boxes;
    /// Index of the first box of each phase; then boxes.size().
    std::vector<std::size_t> phases;

    /// One region: everything.
    FrontRegions();

    bool last(std::size_t region) const { return region + 1 == boxes.size(); }
};

/// True if `inner` lies in `outer`: at its upper limits strictly, so that neighbours share nothing.
constexpr bool holds(const Box2 &outer, const Box2 &inner) {
    return outer.min.x <= inner.min.x && inner.max.x < outer.max.x && outer.min.y <= inner.min.y &&
           inner.max.y < outer.max.y;
}
constexpr bool holds(const Box2 &outer, Vec2 p) {
    return outer.min.x <= p.x && p.x < outer.max.x && outer.min.y <= p.y && p.y < outer.max.y;
}

} // namespace forefront
