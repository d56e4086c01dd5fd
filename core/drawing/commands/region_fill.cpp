#include "core/drawing/commands/region_fill.hpp"

#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/domain/domain_graph.hpp"

namespace forefront {

namespace {

/// Fills in the missing sizes of a marker from another marker.
void keepSizes(MarkedRegion &marker, const MarkedRegion &from) {
    if (marker.maxArea == 0.0) {
        marker.maxArea = from.maxArea;
    }
    if (marker.size == 0.0) {
        marker.size = from.size;
        marker.growth = from.growth;
    }
}

} // namespace

Result<Document> fillRegion(const Document &document, Vec2 at, std::int32_t tag) {
    Result<Repaired> repaired = repair(toDomain(document)); // where segments cross, the faces are those after a repair
    if (!repaired) {
        return repaired.faults();
    }
    Domain &domain = repaired->domain;
    domain.regionMarkers.push_back({at, tag});
    const DomainGraph graph = graphOf(domain);
    const Faces faces = findFaces(graph.points, graph.edges, sweepPlane(graph.points, graph.edges));
    const FaceLabels labels = labelFaces(domain, graph, faces);
    const auto faceOf = [&](std::size_t marker) {
        const std::uint32_t point = graph.regionMarker[marker];
        return point == kNoIndex ? kNoIndex : faces.ofPoint[point];
    };
    const std::uint32_t face = faceOf(document.regionMarkers.size());
    if (face == kNoIndex || labels.inside[face] == 0) {
        Diagnostics fault = error("region-marker-outside", "outside the domain", "click inside a face of the domain");
        fault.front().at = at;
        return fault;
    }
    Document next = document;
    next.regionMarkers.clear();
    MarkedRegion filled{at, tag};
    for (std::size_t k = 0; k < document.regionMarkers.size(); ++k) {
        const MarkedRegion &marker = document.regionMarkers[k];
        if (faceOf(k) != face) {
            next.regionMarkers.push_back(marker);
        } else {
            keepSizes(filled, marker); // a new tag keeps the face's element size
        }
    }
    return addRegionMarker(next, filled);
}

} // namespace forefront
