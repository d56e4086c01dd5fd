#include "core/drawing/domain/domain_shapes.hpp"

#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/boundary_loops.hpp"
#include "core/engine/base/ids.hpp"

#include <algorithm>
#include <numeric>

namespace forefront {
std::vector<Shape> shapesOf(const Domain &domain, LooseEnds ends) {
    std::vector<Shape> shapes;
    const auto loops = boundaryLoops(domain);
    std::vector<std::uint32_t> rest, points(domain.points.size());
    std::iota(points.begin(), points.end(), 0U);
    for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
        if (!loops || domain.segments[s].role == SegmentRole::Constraint) {
            rest.push_back(s);
        }
    }
    if (loops) {
        const ChainPaths paths(domain, ends);
        for (const BoundaryLoop &loop : *loops) {
            shapes.push_back(shapeOf(paths.make(loop.nodes, loop.segments, true)));
        }
    }
    for (const auto &shape : fromDomain(partOf(domain, rest, points), ends).shapes) {
        shapes.push_back(*shape);
        shapes.back().id = 0;
    }
    return shapes;
}

Domain partOf(const Domain &domain, std::span<const std::uint32_t> segments, std::span<const std::uint32_t> points) {
    std::vector<std::uint32_t> number(domain.nodes.size(), kNoIndex);
    const auto use = [&](std::uint32_t node) {
        if (node < number.size()) {
            number[node] = 0;
        }
    };
    for (const std::uint32_t s : segments) {
        use(domain.segments[s].a);
        use(domain.segments[s].b);
    }
    for (const std::uint32_t p : points) {
        use(domain.points[p].node);
    }
    Domain part;
    part.curves = domain.curves;
    part.curveTolerance = domain.curveTolerance;
    for (std::size_t n = 0; n < number.size(); ++n) {
        if (number[n] != kNoIndex) {
            number[n] = static_cast<std::uint32_t>(part.nodes.size());
            part.nodes.push_back(domain.nodes[n]);
        }
    }
    const auto renumbered = [&](std::uint32_t node) { return node < number.size() ? number[node] : kNoIndex; };
    for (const std::uint32_t s : segments) {
        DomainSegment segment = domain.segments[s];
        segment.a = renumbered(segment.a);
        segment.b = renumbered(segment.b);
        part.segments.push_back(segment);
    }
    for (const std::uint32_t p : points) {
        part.points.push_back({renumbered(domain.points[p].node), domain.points[p].tag});
    }
    return part;
}

} // namespace forefront
