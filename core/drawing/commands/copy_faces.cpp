#include "core/drawing/commands/copy_faces.hpp"

#include "core/drawing/domain/document_domain.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Returns a domain whose boundary is the edges around a face.
Domain faceDomain(const FaceMap &map, std::uint32_t face) {
    const Domain &whole = *map.domain();
    Domain domain;
    std::map<std::uint32_t, std::uint32_t> nodes, curves; // of the whole domain, to those of the face
    const auto number = [](std::map<std::uint32_t, std::uint32_t> &numbers, std::uint32_t from, const auto &of,
                           auto &to) {
        const auto [found, fresh] = numbers.emplace(from, static_cast<std::uint32_t>(to.size()));
        if (fresh) {
            to.push_back(of[from]);
        }
        return found->second;
    };
    for (const std::uint32_t e : map.edgesOf(face)) {
        DomainSegment segment = whole.segments[map.edges()[e].segment];
        segment.a = number(nodes, segment.a, whole.nodes, domain.nodes);
        segment.b = number(nodes, segment.b, whole.nodes, domain.nodes);
        segment.role = SegmentRole::Boundary;
        if (segment.stretch.follows()) {
            segment.stretch.curve = number(curves, segment.stretch.curve, whole.curves, domain.curves);
        }
        domain.segments.push_back(segment);
    }
    domain.curveTolerance = whole.curveTolerance;
    return domain;
}

/// Copies the sizes, numbers of elements and layers of boundary parts.
void copyPartSizes(const Document &document, const std::set<std::int32_t> &tags, Document &copy) {
    for (const std::int32_t tag : tags) {
        if (const auto size = document.spacing.partSizes.find(tag); size != document.spacing.partSizes.end()) {
            copy.spacing.partSizes.insert(*size);
        }
        if (const auto count = document.elementCounts.find(tag); count != document.elementCounts.end()) {
            copy.elementCounts.insert(*count);
        }
    }
    std::copy_if(document.layers.begin(), document.layers.end(), std::back_inserter(copy.layers),
                 [&](const LayerSpec &layer) { return tags.contains(layer.tag); });
}

} // namespace

Document copyFaces(const Document &document, const FaceMap &map, const std::set<std::uint32_t> &faces) {
    Document copy;
    copy.circleTolerance = document.circleTolerance;
    copy.curveTolerance = document.curveTolerance;
    copy.unit = document.unit;
    std::set<std::int32_t> tags;
    for (const std::uint32_t face : faces) {
        const Domain outline = faceDomain(map, face);
        for (const DomainSegment &segment : outline.segments) {
            tags.insert(segment.tag);
        }
        for (const auto &shape : fromDomain(outline).shapes) {
            auto own = std::make_shared<Shape>(*shape);
            own->id = copy.nextId++;
            copy.shapes.push_back(std::move(own));
        }
    }
    std::copy_if(document.regionMarkers.begin(), document.regionMarkers.end(), std::back_inserter(copy.regionMarkers),
                 [&](const MarkedRegion &marker) { return faces.contains(map.faceOf(marker)); });
    copy.boundaryNames = document.boundaryNames;
    copy.regionNames = document.regionNames;
    copyPartSizes(document, tags, copy);
    return copy;
}

} // namespace forefront
