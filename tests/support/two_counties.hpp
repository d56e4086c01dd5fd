#pragma once

#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace forefront::test {

/// Returns two counties as an import of a map makes them, moved by `by`: shape 1 bounds the left one (area 12, marker
/// 0, tag 2, name West), shape 2 the right one (area 12, marker 1, tag 3, name East), and shape 3 lies between them.
/// The right marker is near the border: both are within x from 0 to 8 and y from 0 to 3.
inline Document twoCounties(Vec2 by = {}) {
    const auto line = [&](std::vector<Vec2> nodes, ShapeUse use, std::int32_t tag) {
        Shape shape;
        shape.form = PathForm{.closed = false};
        for (const Vec2 node : nodes) {
            shape.nodes.push_back(node + by);
        }
        shape.use = use;
        shape.tag = tag;
        return shape;
    };
    Document document = *addShapes({}, {line({{4, 0}, {0, 0}, {0, 3}, {4, 3}}, ShapeUse::Boundary, 1),
                                        line({{4, 3}, {8, 3}, {8, 0}, {4, 0}}, ShapeUse::Boundary, 1),
                                        line({{4, 0}, {4, 3}}, ShapeUse::Constraint, 2)});
    document.regionNames = {{2, "West"}, {3, "East"}};
    return *addRegionMarker(*addRegionMarker(document, {Vec2{1, 1} + by, 2}), {Vec2{4.5, 1} + by, 3});
}

} // namespace forefront::test
