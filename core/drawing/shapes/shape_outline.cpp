#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/shapes/slot.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace forefront {
namespace {

constexpr std::size_t kMinCorners = 8;
constexpr std::size_t kMaxCorners = 4096;

/// Returns the zero-length segment of a circle without radius, which validation reports with its position.
Outline pointOutline(Vec2 at) {
    return {{at, at}, true, {}, {}};
}

/// Returns the outline of a circle or an ellipse, from its second node towards the end of the semi-axis `v`.
Outline roundOutline(const std::vector<Vec2> &nodes, Vec2 v) {
    const Vec2 u = nodes[1] - nodes[0];
    return cross(u, v) != 0.0 ? Outline{{nodes[1]}, true, {Curve::arc(nodes[0], u, v)}, {}} : pointOutline(nodes[0]);
}

Outline rectangleOutline(const Shape &shape) {
    const Vec2 a = shape.nodes[0], c = shape.nodes[1];
    const std::array<Vec2, 4> corners = {a, Vec2{c.x, a.y}, c, Vec2{a.x, c.y}};
    Outline outline;
    outline.closed = true;
    const double shorter = std::min(std::fabs(c.x - a.x), std::fabs(c.y - a.y));
    const double radius = std::min(shape.as<RectangleForm>().radius, 0.5 * shorter);
    if (!(radius > 0.0)) {
        outline.nodes.assign(corners.begin(), corners.end());
        return outline;
    }
    const Vec2 along{std::copysign(radius, c.x - a.x), 0.0}, up{0.0, std::copysign(radius, c.y - a.y)};
    const std::array<Vec2, 4> ways = {along, up, -1.0 * along, -1.0 * up};
    constexpr double kNoSide = 1.0 - 1e-12; // what is left of such a side is rounding
    for (std::uint32_t k = 0; k < 4; ++k) {
        const Vec2 way = ways[k], next = ways[(k + 1) % 4], corner = corners[(k + 1) % 4];
        const double side = distance(corners[k], corner);
        const bool straight = 2.0 * radius < kNoSide * side;
        const Vec2 end = straight ? corner - way : midpoint(corners[k], corner);
        if (straight) {
            outline.nodes.push_back(corners[k] + way);
            outline.curves.emplace_back();
            outline.parts.push_back(k);
        }
        outline.nodes.push_back(end);
        outline.curves.push_back(Curve::arc(corner - way + next, -1.0 * next, way, 0.0, 0.5 * std::numbers::pi));
        outline.parts.push_back(4 + k);
    }
    return outline;
}

/// Returns the parameters of the chords of a curve, from the first after 0 up to 1.
std::vector<double> chordEnds(const Curve &curve, double tolerance, bool isLoop) {
    std::vector<double> ends;
    const auto evenly = [&](std::size_t count) {
        ends.clear();
        for (std::size_t k = 1; k <= count; ++k) {
            ends.push_back(static_cast<double>(k) / static_cast<double>(count));
        }
    };
    if (curve.kind() == CurveKind::Arc && isLoop) {
        evenly(circleCorners(tolerance));
        return ends;
    }
    double size = 0.5 * curve.bounds().diagonal();
    if (curve.kind() == CurveKind::Arc) {
        const auto n = curve.numbers();
        size = std::min(size, std::max(length({n[2], n[3]}), length({n[4], n[5]})));
    }
    ends = curve.flatten(std::max(tolerance, 1e-9) * size);
    constexpr std::size_t kLoop = 3; // fewer would enclose nothing
    if (isLoop && ends.size() < kLoop) {
        evenly(kLoop);
    }
    return ends;
}

} // namespace

std::size_t circleCorners(double tolerance) {
    if (!(tolerance > 0.0)) {
        return kMaxCorners;
    }
    if (tolerance >= 1.0) {
        return kMinCorners;
    }
    // Sagitta of a chord over the angle 2π/n: r·(1 − cos(π/n)).
    const double corners = std::ceil(std::numbers::pi / std::acos(1.0 - tolerance));
    if (!(corners < static_cast<double>(kMaxCorners))) {
        return kMaxCorners;
    }
    return std::max(kMinCorners, (static_cast<std::size_t>(corners) + 3) / 4 * 4);
}

Outline outlineOf(const Shape &shape) {
    const std::vector<Vec2> &nodes = shape.nodes;
    // For points, and for shapes with a wrong number of nodes.
    const auto plain = [&nodes] { return Outline{nodes, false, {}, {}}; };
    return shape.visit(
        [&](const PathForm &path) {
            return Outline{nodes, path.closed, path.curves, {}};
        },
        [&](const RectangleForm &) { return nodes.size() == 2 ? rectangleOutline(shape) : plain(); },
        [&](const CircleForm &) {
            if (nodes.size() != 2) {
                return plain();
            }
            const Vec2 arm = nodes[1] - nodes[0];
            return lengthSquared(arm) > 0.0 ? roundOutline(nodes, leftNormal(arm)) : pointOutline(nodes[0]);
        },
        [&](const PointForm &) { return plain(); },
        [&](const EllipseForm &) { return nodes.size() == 3 ? roundOutline(nodes, nodes[2] - nodes[0]) : plain(); },
        [&](const SlotForm &) {
            return nodes.size() != 2 ? plain() : isSoundSlot(shape) ? slotOutline(shape) : pointOutline(nodes[0]);
        });
}

Chords chordsOf(const Shape &shape, const Outline &outline, double circleTolerance) {
    Chords chords;
    chords.closed = outline.closed;
    const std::size_t count = outline.segmentCount();
    for (std::uint32_t k = 0; k < count; ++k) {
        chords.nodes.push_back(outline.from(k));
        if (!outline.isCurved(k)) {
            chords.segments.push_back(k);
            chords.stretches.emplace_back();
            continue;
        }
        const Curve &curve = outline.curves[k];
        std::vector<double> ends;
        if (k < shape.cuts.size() && !shape.cuts[k].empty()) {
            ends = shape.cuts[k];
            if (ends.back() < 1.0) {
                ends.push_back(1.0);
            }
        } else {
            ends = chordEnds(curve, circleTolerance, count == 1 && outline.closed);
        }
        double from = 0.0;
        for (const double to : ends) {
            chords.segments.push_back(k);
            chords.stretches.push_back({k, from, to});
            if (to != 1.0) {
                chords.nodes.push_back(curve.point(to));
            }
            from = to;
        }
    }
    if (count > 0 && count < outline.nodes.size()) {
        chords.nodes.push_back(outline.nodes.back()); // an open end
    } else if (count == 0) {
        chords.nodes = outline.nodes;
    }
    return chords;
}

} // namespace forefront
