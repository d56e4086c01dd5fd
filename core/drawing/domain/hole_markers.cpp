#include "core/drawing/domain/hole_markers.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/domain/domain_graph.hpp"

#include <vector>

namespace forefront {

Domain withEvenOddRoles(const Domain &domain) {
    Domain result = domain;
    result.holeMarkers.clear();
    result.insideRule = InsideRule::EvenOdd;
    const DomainGraph graph = graphOf(domain);
    const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges);
    if (sweep.droppedCount > 0) {
        return result;
    }
    const Faces faces = findFaces(graph.points, graph.edges, sweep);
    const FaceLabels labels = labelFaces(domain, graph, faces);
    std::vector<std::uint8_t> boundsNothing(domain.segments.size(), 0);
    for (std::size_t edge = 0; edge < graph.edges.size(); ++edge) {
        const bool left = labels.inside[faces.left[edge]] != 0, right = labels.inside[faces.right[edge]] != 0;
        const std::uint32_t segment = graph.segment[edge];
        if (faces.left[edge] == 0 && faces.right[edge] == 0 && domain.segments[segment].role == SegmentRole::Boundary) {
            continue;
        }
        result.segments[segment].role = left != right ? SegmentRole::Boundary : SegmentRole::Constraint;
        boundsNothing[segment] = !left && !right ? 1 : 0;
    }
    std::vector<DomainSegment> kept;
    for (std::size_t k = 0; k < result.segments.size(); ++k) {
        if (boundsNothing[k] == 0) {
            kept.push_back(result.segments[k]);
        }
    }
    result.segments = std::move(kept);
    return result;
}

std::vector<Vec2> idleHoleMarkers(const Domain &domain) {
    if (domain.insideRule != InsideRule::HoleMarkers || domain.holeMarkers.empty()) {
        return {};
    }
    const DomainGraph graph = graphOf(domain);
    const PlaneSweepResult sweep = sweepPlane(graph.points, graph.edges);
    if (sweep.droppedCount > 0) {
        return domain.holeMarkers;
    }
    const Faces faces = findFaces(graph.points, graph.edges, sweep);
    std::vector<Vec2> idle;
    for (std::size_t k = 0; k < graph.holeMarker.size(); ++k) {
        const std::uint32_t point = graph.holeMarker[k];
        const std::uint32_t face = point == kNoIndex ? kNoIndex : faces.ofPoint[point];
        if (face == kNoIndex || face == 0) {
            idle.push_back(domain.holeMarkers[k]);
        }
    }
    return idle;
}

} // namespace forefront
