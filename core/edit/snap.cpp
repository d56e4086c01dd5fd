#include "core/edit/snap.hpp"

#include "core/edit/plane_map.hpp"
#include "core/edit/snap_points.hpp"

#include <numbers>

namespace forefront {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Vec2 alongAngle(Vec2 anchor, Vec2 p, double degrees) {
    const Vec2 ray = unitVector(degrees);
    return anchor + std::max(0.0, dot(p - anchor, ray)) * ray;
}

/// Applies the locks to a place that has already snapped.
Vec2 applyLocks(const SnapQuery &query, Vec2 p) {
    const SnapLocks &locks = query.locks;
    if (query.anchor) {
        const Vec2 anchor = *query.anchor;
        if (locks.angle) {
            p = locks.distance ? anchor + *locks.distance * unitVector(*locks.angle)
                               : alongAngle(anchor, p, *locks.angle);
        } else if (locks.distance) {
            const Vec2 arm = p - anchor;
            const double reach = length(arm);
            p = anchor + *locks.distance * (reach > 0.0 ? (1.0 / reach) * arm : Vec2{1.0, 0.0});
        }
    }
    if (locks.x) {
        p.x = *locks.x;
    }
    if (locks.y) {
        p.y = *locks.y;
    }
    return p;
}

std::optional<Vec2> gridPoint(const SnapQuery &query) {
    if (!(query.gridPitch > 0.0)) {
        return std::nullopt;
    }
    const Vec2 point{std::round(query.at.x / query.gridPitch) * query.gridPitch,
                     std::round(query.at.y / query.gridPitch) * query.gridPitch};
    const double reach = std::min(query.tolerance, 0.35 * query.gridPitch);
    return distance(point, query.at) <= reach ? std::optional(point) : std::nullopt;
}

} // namespace

const char *wordOf(SnapKind kind) {
    switch (kind) {
    case SnapKind::Node:
        return "node";
    case SnapKind::Midpoint:
        return "midpoint";
    case SnapKind::Centre:
        return "centre";
    case SnapKind::Intersection:
        return "intersection";
    case SnapKind::Perpendicular:
        return "perpendicular";
    case SnapKind::Tangent:
        return "tangent";
    case SnapKind::Segment:
        return "on line";
    case SnapKind::None:
    case SnapKind::Grid:
    case SnapKind::Angle:
    case SnapKind::Locked:
        break;
    }
    return "";
}

Snapped snap(const PickIndex &index, const SnapQuery &query) {
    if (query.locks.any()) {
        // Coordinates that are not locked still snap: a typed distance points exactly at the node under the pointer.
        SnapQuery free = query;
        free.locks = {};
        return {applyLocks(query, snap(index, free).at), SnapKind::Locked, {}};
    }
    if (query.off) {
        return {query.at, SnapKind::None, {}};
    }
    if (query.angle && query.anchor) {
        const Vec2 arm = query.at - *query.anchor;
        const double degrees = std::atan2(arm.y, arm.x) / kDegree;
        return {
            alongAngle(*query.anchor, query.at, std::round(degrees / kSnapAngle) * kSnapAngle), SnapKind::Angle, {}};
    }
    if (const auto node = index.node(query.at, query.tolerance, query.filter)) {
        const Shape *const shape = findShape(index.document(), node->ref.shape);
        const bool centre = isRound(*shape) && node->ref.node == 0;
        return {node->at, centre ? SnapKind::Centre : SnapKind::Node, {}};
    }
    if (const auto special = specialPoint(index, query)) {
        return *special;
    }
    if (const auto segment = index.segment(query.at, query.tolerance, query.filter)) {
        return {segment->at, SnapKind::Segment, segment};
    }
    if (const auto point = gridPoint(query)) {
        return {*point, SnapKind::Grid, {}};
    }
    return {query.at, SnapKind::None, {}};
}

double gridPitch(double unitsPerPixel, double minPixels) {
    const double minimum = unitsPerPixel * minPixels;
    if (!(minimum > 0.0) || !std::isfinite(minimum)) {
        return 0.0;
    }
    const double decade = std::pow(10.0, std::floor(std::log10(minimum)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * decade >= minimum) {
            return step * decade;
        }
    }
    return 10.0 * decade;
}

} // namespace forefront
