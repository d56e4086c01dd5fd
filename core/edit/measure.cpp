#include "core/edit/measure.hpp"

#include "core/base/ids.hpp"
#include "core/domain/domain_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace forefront {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kTurn = 2.0 * std::numbers::pi;

void measureArc(const Curve &curve, std::vector<Quantity> &found) {
    const auto n = curve.numbers();
    const Vec2 u{n[2], n[3]}, v{n[4], n[5]};
    const double radius = length(u), sweep = std::fabs(n[7]);
    const bool whole = sweep > kTurn * (1.0 - 1e-12);
    const bool circular =
        std::fabs(length(v) - radius) <= 1e-9 * radius && std::fabs(dot(u, v)) <= 1e-9 * radius * radius;
    if (circular) {
        found = {{"radius", radius}, {"diameter", 2.0 * radius}};
    } else {
        found = {{"semi-axis", radius}, {"other semi-axis", length(v)}};
    }
    if (!whole) {
        found.push_back({"arc length", curve.length()});
        found.push_back({"angle", sweep * kDegrees, true});
    } else {
        found.push_back({"circumference", curve.length()});
        found.push_back({"area", std::numbers::pi * std::fabs(cross(u, v))});
    }
}

/// Returns twice the area that the way along a stretch of a curve covers, seen from `origin`; by Gauss's rule with 4
/// nodes, since stretches bend little.
double coveredTwice(const Curve &curve, const CurveStretch &stretch, Vec2 origin) {
    constexpr std::array<double, 4> kNodes{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                           0.8611363115940526};
    constexpr std::array<double, 4> kWeights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                             0.3478548451374538};
    constexpr int kPieces = 4;
    const double step = (stretch.t1 - stretch.t0) / kPieces;
    double sum = 0.0;
    for (int piece = 0; piece < kPieces; ++piece) {
        for (std::size_t k = 0; k < kNodes.size(); ++k) {
            const double t = stretch.t0 + step * (piece + 0.5 * (1.0 + kNodes[k]));
            sum += 0.5 * step * kWeights[k] * cross(curve.point(t) - origin, curve.derivative(t));
        }
    }
    return sum;
}

} // namespace

double angleBetween(Vec2 u, Vec2 v) {
    return std::fabs(std::atan2(cross(u, v), dot(u, v))) * kDegrees;
}

std::vector<Quantity> measureCurve(const Curve &curve) {
    std::vector<Quantity> found;
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
        const double twice = curve != nullptr ? coveredTwice(*curve, stretch, at) : cross(a - at, b - at);
        measure.area += left ? 0.5 * twice : -0.5 * twice;
        measure.perimeter += curve != nullptr
                                 ? curve->length(std::min(stretch.t0, stretch.t1), std::max(stretch.t0, stretch.t1))
                                 : distance(a, b);
        measure.segments.push_back(number);
    }
    return measure;
}

} // namespace forefront
