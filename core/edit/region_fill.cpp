#include "core/edit/region_fill.hpp"

#include "core/edit/drawn_faces.hpp"
#include "core/edit/region_commands.hpp"

namespace forefront {
namespace {

bool isInside(const Domain &domain, Vec2 p) {
    bool inside = false;
    for (const DomainSegment &s : domain.segments) {
        const Vec2 a = domain.nodes[s.a], b = domain.nodes[s.b];
        if (s.role == SegmentRole::Boundary && (a.y > p.y) != (b.y > p.y) &&
            p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) {
            inside = !inside;
        }
    }
    return inside;
}

} // namespace

Result<Document> fillRegion(const Document &document, Vec2 at, std::int32_t tag) {
    const Domain domain = traceable(toDomain(document));
    if (!isFinite(at) || !isInside(domain, at)) {
        Diagnostics fault =
            error("region-marker-outside", "there is no domain here", "click into a face of the domain");
        fault.front().at = at;
        return fault;
    }
    DrawnFaces faces(domain);
    const std::uint32_t face = faces.faceAt(at);
    Document next = document;
    std::erase_if(next.regionMarkers, [&](const RegionMarker &marker) { return faces.faceAt(marker.at) == face; });
    return addRegionMarker(next, {at, tag});
}

} // namespace forefront
