#include "core/edit/hole_markers.hpp"

#include "core/edit/drawn_faces.hpp"

#include <algorithm>

namespace forefront {

Domain withEvenOddRoles(const Domain &domain) {
    Domain result = traceable(domain);
    DrawnFaces faces(result);
    std::vector<std::uint32_t> outside{faces.unbounded()};
    for (const Vec2 marker : domain.holeMarkers) {
        outside.push_back(faces.faceAt(marker));
    }
    std::sort(outside.begin(), outside.end());
    const auto inside = [&](std::uint32_t halfEdge) {
        return !std::binary_search(outside.begin(), outside.end(), faces.face(halfEdge));
    };
    std::vector<DomainSegment> kept;
    for (const DomainSegment &s : domain.segments) {
        // What cannot be traced stays for validation to report.
        if (s.a < domain.nodes.size() && s.b < domain.nodes.size() && !isTraceable(domain, s)) {
            kept.push_back(s);
        }
    }
    for (std::uint32_t s = 0; s < result.segments.size(); ++s) {
        const bool left = inside(2 * s), right = inside(2 * s + 1);
        if (left || right) {
            kept.push_back(result.segments[s]);
            kept.back().role = left != right ? SegmentRole::Boundary : SegmentRole::Constraint;
        }
    }
    result.segments = std::move(kept);
    result.holeMarkers.clear();
    result.insideRule = InsideRule::EvenOdd;
    return result;
}

} // namespace forefront
