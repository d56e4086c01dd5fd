#include "tests/support/curved_area.hpp"

#include "core/engine/domain/domain_graph.hpp"

#include <array>
#include <utility>

namespace forefront::testing {

double sweptArea(const Curve &curve, double t0, double t1, Vec2 origin) {
    const Vec2 a = curve.point(t0) - origin, b = curve.point(t1) - origin;
    const auto numbers = curve.numbers();
    switch (curve.kind()) {
    case CurveKind::Line:
        return 0.5 * cross(a, b);
    case CurveKind::Arc: {
        const Vec2 centre = Vec2{numbers[0], numbers[1]} - origin, u{numbers[2], numbers[3]}, v{numbers[4], numbers[5]};
        return 0.5 * (cross(centre, b - a) + (t1 - t0) * numbers[7] * cross(u, v));
    }
    case CurveKind::Cubic: {
        const auto n = curve.part(t0, t1).numbers();
        const auto p = [&](std::size_t k) { return Vec2{n[2 * k], n[2 * k + 1]} - origin; };
        return (6.0 * cross(p(0), p(1)) + 3.0 * cross(p(0), p(2)) + cross(p(0), p(3)) + 3.0 * cross(p(1), p(2)) +
                3.0 * cross(p(1), p(3)) + 6.0 * cross(p(2), p(3))) /
               20.0;
    }
    }
    return 0.0;
}

std::map<std::int32_t, double> curvedAreas(const Domain &domain) {
    const DomainGraph graph = graphOf(domain);
    const Faces faces = findFaces(graph.points, graph.edges, sweepPlane(graph.points, graph.edges));
    const FaceLabels labels = labelFaces(domain, graph, faces);
    const Vec2 origin = domain.bounds().centre();
    std::map<std::int32_t, double> areas;
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        const DomainSegment &segment = domain.segments[graph.segment[e]];
        const Vec2 a = domain.nodes[segment.a] - origin, b = domain.nodes[segment.b] - origin;
        double area = 0.5 * cross(a, b);
        if (segment.stretch.follows()) { // ends may be off the curve by a tolerance
            const Curve &curve = domain.curves[segment.stretch.curve];
            const double t0 = segment.stretch.t0, t1 = segment.stretch.t1;
            area = sweptArea(curve, t0, t1, origin) + 0.5 * cross(a, curve.point(t0) - origin) +
                   0.5 * cross(curve.point(t1) - origin, b);
        }
        for (const auto &[face, sign] : {std::pair{faces.left[e], 1.0}, {faces.right[e], -1.0}}) {
            if (labels.inside[face] != 0) {
                areas[labels.tag[face]] += sign * area;
            }
        }
    }
    return areas;
}

} // namespace forefront::testing
