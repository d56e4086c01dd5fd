#include "core/drawing/picking/pointer_snap.hpp"

#include "core/drawing/picking/snap_points.hpp"
#include "core/drawing/shapes/plane_map.hpp"

#include <array>
#include <cstdio>
#include <numbers>
#include <utility>

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

/// Returns the line of the grid nearest to a coordinate; without a grid, the coordinate.
double gridLine(const SnapQuery &query, double coordinate) {
    if (!(query.gridPitch > 0.0)) {
        return coordinate;
    }
    // A pitch such as 0.1 is rounded, but its inverse is not: 0.3 is 3 / 10, not 3 * 0.1.
    const double inverse = 1.0 / query.gridPitch, whole = std::round(inverse);
    const bool isPart = whole > 1.0 && std::fabs(inverse - whole) <= 1e-12 * whole;
    const double line =
        isPart ? std::round(coordinate * whole) / whole : std::round(coordinate / query.gridPitch) * query.gridPitch;
    return line + 0.0; // no negative zero
}

std::optional<Vec2> gridPoint(const SnapQuery &query) {
    return query.gridPitch > 0.0 ? std::optional(Vec2{gridLine(query, query.at.x), gridLine(query, query.at.y)})
                                 : std::nullopt;
}

/// Returns true if the pointer is near a point of the grid.
bool isNearGrid(const SnapQuery &query) {
    const std::optional<Vec2> point = gridPoint(query);
    return point && distance(*point, query.at) <= std::min(query.tolerance, 0.35 * query.gridPitch);
}

/// Moves a place on a level or upright segment along it to a line of the grid, unless that is beyond its ends.
Vec2 alongSegment(const SnapQuery &query, const SegmentHit &hit) {
    const Vec2 low{std::min(hit.a.x, hit.b.x), std::min(hit.a.y, hit.b.y)};
    const Vec2 high{std::max(hit.a.x, hit.b.x), std::max(hit.a.y, hit.b.y)};
    Vec2 at = hit.at;
    if (hit.curve || (low.x == high.x) == (low.y == high.y)) {
        return at;
    }
    if (low.y == high.y) {
        at.x = gridLine(query, at.x);
    } else {
        at.y = gridLine(query, at.y);
    }
    const bool within = at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y;
    return within ? at : hit.at;
}

/// Moves a place that is level with another or above it, and bound to nothing else, along that line to the grid.
Vec2 alongRelation(const SnapQuery &query, const InferredPlace &inferred) {
    Vec2 at = inferred.at;
    if (inferred.relations.size() == 1 && inferred.relations.front().kind == ConstraintKind::Horizontal) {
        at.x = gridLine(query, at.x);
    } else if (inferred.relations.size() == 1 && inferred.relations.front().kind == ConstraintKind::Vertical) {
        at.y = gridLine(query, at.y);
    }
    return at;
}

} // namespace

namespace {

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
    case SnapKind::Guide:
        return "guide";
    case SnapKind::Grid:
        return "grid";
    case SnapKind::Angle:
        return "angle";
    case SnapKind::Locked:
        return "locked";
    case SnapKind::Inferred: // its relations have words
    case SnapKind::None:
        break;
    }
    return "";
}

/// Returns the direction from a to b in degrees, a multiple of `step` in [0, 360).
double steppedDirection(Vec2 a, Vec2 b, double step) {
    const Vec2 arm = b - a;
    const double degrees = std::round(std::atan2(arm.y, arm.x) / kDegree / step) * step;
    return degrees < 0.0 ? degrees + 360.0 : degrees >= 360.0 ? degrees - 360.0 : degrees + 0.0; // not -0
}

/// Returns the place on the guides near the pointer; the co-ordinate that they leave snaps to the grid.
std::optional<Vec2> guidePoint(const Document &document, const SnapQuery &query) {
    std::optional<double> x, y;
    for (const Guide &guide : document.guides) {
        const double at = guide.upright ? query.at.x : query.at.y;
        std::optional<double> &best = guide.upright ? x : y;
        const double away = std::fabs(guide.at - at);
        if (away <= query.tolerance && (!best || away < std::fabs(*best - at))) {
            best = guide.at;
        }
    }
    if (!x && !y) {
        return std::nullopt;
    }
    return Vec2{x ? *x : gridLine(query, query.at.x), y ? *y : gridLine(query, query.at.y)};
}

Snapped snapLocked(const PickIndex &index, const SnapQuery &query) {
    // Coordinates that are not locked still snap: a typed distance points exactly at the node under the pointer.
    SnapQuery free = query;
    free.locks = {};
    if ((query.locks.distance || query.locks.angle) && !isNearGrid(query)) {
        free.gridPitch = 0.0; // the point will not lie on the grid
    }
    const Snapped target = snap(index, free);
    Snapped locked{applyLocks(query, target.at), SnapKind::Locked};
    locked.locks = query.locks;
    locked.within = query.locks.x && query.locks.y ? SnapKind::None : target.kind;
    if (query.locks.distance || query.locks.angle) {
        locked.from = query.anchor;
    }
    return locked;
}

} // namespace

Snapped lockedAt(Vec2 place) {
    Snapped locked{place, SnapKind::Locked};
    locked.locks.x = place.x;
    locked.locks.y = place.y;
    return locked;
}

std::string wordsOf(const Snapped &snapped) {
    if (snapped.kind == SnapKind::Angle) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "angle %.4g\xc2\xb0", snapped.degrees);
        return text.data();
    }
    if (snapped.kind != SnapKind::Locked) {
        std::string words = wordOf(snapped.kind);
        for (const Inference &relation :
             snapped.kind == SnapKind::Inferred ? snapped.inferred : std::vector<Inference>()) {
            words += (words.empty() ? "" : ", ") + wordsOf(relation);
        }
        return words;
    }
    std::string words;
    const SnapLocks &locks = snapped.locks;
    for (const auto &[lock, name] :
         {std::pair(locks.x, "x"), std::pair(locks.y, "y"),
          std::pair(locks.distance, locks.isRadius ? "radius" : "length"), std::pair(locks.angle, "angle")}) {
        if (lock) {
            words += (words.empty() ? "" : ", ") + std::string(name);
        }
    }
    words += words.empty() ? "locked" : " locked";
    return snapped.within == SnapKind::None ? words : words + ", " + wordOf(snapped.within);
}

namespace {

/// Snaps a point to parts of the drawing and guides.
Snapped snapToTargets(const PickIndex &index, const SnapQuery &query) {
    if (query.angle && query.anchor && query.at != *query.anchor) {
        Snapped turned{{}, SnapKind::Angle};
        turned.degrees = steppedDirection(*query.anchor, query.at, query.angleStep);
        turned.at = alongAngle(*query.anchor, query.at, turned.degrees);
        turned.from = query.anchor;
        return turned;
    }
    if (const auto node = index.node(query.at, query.tolerance, query.filter)) {
        const Shape *const shape = findShape(index.document(), node->ref.shape);
        const bool centre = isCentre(*shape, node->ref.node);
        const bool side = shape->is<SlotForm>() && !centre;
        return {node->at, centre ? SnapKind::Centre : side ? SnapKind::Midpoint : SnapKind::Node};
    }
    if (const auto special = specialPoint(index, query)) {
        return *special;
    }
    if (const auto segment = index.segment(query.at, query.tolerance, query.filter)) {
        return {alongSegment(query, *segment), SnapKind::Segment, segment};
    }
    if (const auto point = query.guides ? guidePoint(index.document(), query) : std::nullopt) {
        return {*point, SnapKind::Guide};
    }
    return {query.at};
}

/// Snaps a point that meets no part of the drawing to inferred relations or to the grid.
Snapped snapBetween(const PickIndex &index, const SnapQuery &query) {
    const std::optional<Vec2> grid = gridPoint(query);
    auto inferred = query.infer ? inferRelations(index, query.filter, *query.infer, query.at, query.tolerance)
                                : std::optional<InferredPlace>();
    if (inferred) {
        Snapped snapped{alongRelation(query, *inferred), SnapKind::Inferred};
        if (!grid || snapped.at == *grid || distance(snapped.at, query.at) < distance(*grid, query.at)) {
            snapped.kind = grid == snapped.at ? SnapKind::Grid : SnapKind::Inferred;
            snapped.inferred = std::move(inferred->relations);
            return snapped;
        }
    }
    if (!grid) {
        return {query.at};
    }
    Snapped snapped{*grid, SnapKind::Grid};
    snapped.inferred = query.infer ? relationsAt(*query.infer, *grid) : std::vector<Inference>();
    return snapped;
}

} // namespace

Snapped snap(const PickIndex &index, const SnapQuery &query) {
    if (query.locks.any()) {
        return snapLocked(index, query);
    }
    if (query.off) {
        return {query.at};
    }
    Snapped snapped = snapToTargets(index, query);
    if (snapped.kind == SnapKind::None) {
        return snapBetween(index, query);
    }
    if (query.infer && snapped.kind != SnapKind::Angle) {
        snapped.inferred = relationsAt(*query.infer, snapped.at);
    }
    return snapped;
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

double steppedPitch(double step, double unitsPerPixel) {
    constexpr double kLeastPixels = 6.0;
    if (!(step > 0.0) || !std::isfinite(step)) {
        return gridPitch(unitsPerPixel);
    }
    const double coarser = gridPitch(unitsPerPixel / step, kLeastPixels);
    return coarser > 1.0 ? step * coarser : step;
}

} // namespace forefront
