#include "core/drawing/commands/stretch_arcs.hpp"

#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/curve.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace forefront {
namespace {

constexpr double kArcRounding = 1e-9; // of the radius of an arc

/// Returns the movement of an arc of a circle: along each axis that of the places where the arc is parallel to the
/// other axis. None if there is no such place for an axis, or if several move differently.
std::optional<Vec2> movementOf(const Curve &arc, double radius, const PlaneMap &map) {
    const std::array<double, 8> numbers = arc.numbers();
    const Vec2 centre{numbers[0], numbers[1]};
    const double near = kArcRounding * radius;
    std::optional<double> along[2];
    for (const Vec2 side : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
        const Vec2 place = centre + radius * side;
        if (distance(arc.point(arc.nearest(place)), place) > near) {
            continue;
        }
        const Vec2 by = map(place) - place;
        const std::size_t axis = side.x != 0.0 ? 0 : 1;
        const double step = axis == 0 ? by.x : by.y;
        if (along[axis] && std::fabs(*along[axis] - step) > near) {
            return std::nullopt;
        }
        along[axis] = along[axis].value_or(step);
    }
    return along[0] && along[1] ? std::optional(Vec2{*along[0], *along[1]}) : std::nullopt;
}

} // namespace

bool stretchesAlongAxes(const PlaneMap &map) {
    return map.u.y == 0.0 && map.v.x == 0.0 && map.u.x > 0.0 && map.v.y > 0.0 && !map.isSimilarity();
}

std::optional<Shape> stretchedWithArcs(const Shape &path, const PlaneMap &map) {
    if (!isPath(path) || path.path().curves.empty()) {
        return std::nullopt;
    }
    Shape stretched = path;
    std::vector<Curve> &curves = stretched.path().curves;
    std::vector<std::optional<Vec2>> moved(path.nodes.size()); // by the arcs that end there
    double largest = 0.0;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        if (curves[k].kind() == CurveKind::Line) {
            continue;
        }
        const std::optional<double> radius = radiusOf(curves[k]);
        const std::optional<Vec2> by = radius ? movementOf(curves[k], *radius, map) : std::nullopt;
        if (!by) {
            return std::nullopt;
        }
        largest = std::max(largest, *radius);
        curves[k] = curves[k].mapped(PlaneMap::translation(*by));
        for (const std::size_t end : {k, (k + 1) % path.nodes.size()}) {
            if (moved[end] && distance(*moved[end], *by) > kArcRounding * *radius) {
                return std::nullopt;
            }
            moved[end] = moved[end].value_or(*by);
        }
    }
    for (std::size_t k = 0; k < path.nodes.size(); ++k) {
        stretched.nodes[k] = moved[k] ? path.nodes[k] + *moved[k] : map(path.nodes[k]);
    }
    return largest > 0.0 ? std::optional(std::move(stretched)) : std::nullopt;
}

bool keepsConstraints(const Document &before, const Document &after) {
    return std::all_of(before.constraints.begin(), before.constraints.end(), [&](const auto &constraint) {
        const SketchConstraint *const kept = findConstraint(after, constraint->id);
        return kept != nullptr && constraintFault(after, *kept).empty();
    });
}

} // namespace forefront
