#include "core/drawing/shapes/measure.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace forefront {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kTurn = 2.0 * std::numbers::pi;

/// Returns the semi-axes of the ellipse cos t·u + sin t·v, the longer one first: the singular values of its map.
Vec2 semiAxes(Vec2 u, Vec2 v) {
    // |u ± rotated v| are their sum and their difference.
    const double sum = length(u - leftNormal(v)), difference = length(u + leftNormal(v));
    return {0.5 * (sum + difference), 0.5 * std::fabs(sum - difference)};
}

void measureArc(const Curve &curve, std::vector<SegmentMeasure> &found) {
    const auto n = curve.numbers();
    const Vec2 u{n[2], n[3]}, v{n[4], n[5]};
    const double sweep = std::fabs(n[7]);
    const bool whole = sweep > kTurn * (1.0 - 1e-12);
    const std::optional<double> radius = radiusOf(curve);
    if (radius) {
        found = {{"radius", *radius}, {"diameter", 2.0 * *radius}};
    } else {
        const Vec2 axes = semiAxes(u, v);
        found = {{"semi-axis", axes.x}, {"other semi-axis", axes.y}};
    }
    if (!whole) {
        found.push_back({"arc length", curve.length()});
        if (radius) { // that of an ellipse is an angle of its parameter only
            found.push_back({"angle", sweep * kDegrees, true});
        }
    } else {
        found.push_back({"circumference", curve.length()});
        found.push_back({"area", std::numbers::pi * std::fabs(cross(u, v))});
    }
}

} // namespace

double angleBetween(Vec2 u, Vec2 v) {
    return std::fabs(std::atan2(cross(u, v), dot(u, v))) * kDegrees;
}

std::vector<SegmentMeasure> measureCurve(const Curve &curve) {
    std::vector<SegmentMeasure> found;
    if (curve.kind() == CurveKind::Arc) {
        measureArc(curve, found);
        return found;
    }
    found.push_back({"length", curve.length()});
    if (curve.kind() == CurveKind::Line) {
        const Vec2 arm = curve.point(1.0) - curve.point(0.0);
        found.push_back({"\xce\x94x", arm.x});
        found.push_back({"\xce\x94y", arm.y});
        found.push_back({"direction", std::atan2(arm.y, arm.x) * kDegrees, true});
    }
    return found;
}

std::optional<FaceMeasure> measureFace(const Domain &domain, Vec2 at) {
    Domain marked = domain;
    marked.regionMarkers = {{at, 1}};
    const DomainGraph graph = graphOf(marked);
    const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges);
    const std::uint32_t point = graph.regionMarker.front();
    if (sweep.droppedCount > 0 || point == kNoIndex) {
        return std::nullopt;
    }
    const Faces faces = findFaces(graph.points, graph.edges, sweep);
    const std::uint32_t face = faces.ofPoint[point];
    if (face == kNoIndex || face == 0) {
        return std::nullopt;
    }
    FaceMeasure measure;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        const bool left = faces.left[e] == face, right = faces.right[e] == face;
        if (left == right) {
            continue; // elsewhere, or a line that ends inside the face
        }
        const std::uint32_t number = graph.segment[e];
        const DomainSegment &segment = domain.segments[number];
        const Vec2 a = domain.nodes[segment.a], b = domain.nodes[segment.b];
        const CurveStretch &stretch = segment.stretch;
        const Curve *const curve = stretch.follows() ? &domain.curves[stretch.curve] : nullptr;
        const double covered =
            curve != nullptr ? sectorArea(curve->part(stretch.t0, stretch.t1), at) : 0.5 * cross(a - at, b - at);
        measure.area += left ? covered : -covered;
        measure.perimeter += curve != nullptr
                                 ? curve->length(std::min(stretch.t0, stretch.t1), std::max(stretch.t0, stretch.t1))
                                 : distance(a, b);
        measure.segments.push_back(number);
    }
    return measure;
}

} // namespace forefront
