#pragma once

#include "core/drawing/domain/document_domain.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "tests/support/meshed_job.hpp"
#include "tests/unit/edit_support.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

namespace forefront::edit_test {

/// Returns the number of segments within a domain, which separate nothing from its outside.
inline std::size_t innerLines(const Domain &domain) {
    return static_cast<std::size_t>(
        std::count_if(domain.segments.begin(), domain.segments.end(),
                      [](const DomainSegment &segment) { return segment.role == SegmentRole::Constraint; }));
}

/// Returns the sum of the areas of the elements, of size 0.5, of a drawing.
inline double meshedArea(Document document) {
    document.spacing.size = 0.5;
    const Mesh mesh = forefront::testing::meshedJob(jobOf(document)).mesh;
    double area = 0.0;
    for (const Element &e : mesh.triangles()) {
        const auto at = [&](std::size_t k) { return mesh.nodes[index(e[k])]; };
        area += 0.5 * cross(at(1) - at(0), at(2) - at(0));
    }
    return area;
}

/// Returns a polygon one of whose segments is a curve.
inline Shape withCurve(const std::vector<Vec2> &nodes, std::size_t segment, const Curve &curve) {
    Shape shape = makeShape(ShapeKind::Polygon, nodes);
    std::vector<Curve> curves(nodes.size(), Curve::line({}, {}));
    curves[segment] = curve;
    std::get<PathForm>(shape.form).curves = curves;
    return shape;
}

} // namespace forefront::edit_test
