#include "core/drawing/picking/selected_faces.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"

#include <iterator>
#include <vector>

namespace forefront {
namespace {

/// Distance within which a line lies on an edge of a face, relative to the domain: that of joints.
constexpr double kOnEdge = 1e-6;

Vec2 middleOf(const FaceMap &map, const MappedEdge &edge) {
    const Curve *const curve = map.curveOf(edge);
    return curve != nullptr ? curve->point(0.5 * (edge.stretch.t0 + edge.stretch.t1)) : midpoint(edge.a, edge.b);
}

} // namespace

std::set<std::uint32_t> selectedFaces(const FaceMap &map, const Document &document, const Selection &selection) {
    std::set<std::uint32_t> faces;
    for (const std::uint32_t k : selection.markers) {
        if (k < document.regionMarkers.size()) {
            faces.insert(map.faceOf(document, k));
        }
    }
    for (const Vec2 place : selection.faces) {
        faces.insert(map.faceAt(place));
    }
    faces.erase(kNoIndex);
    return faces;
}

bool isFaceSelected(const FaceMap &map, const Document &document, const Selection &selection, std::uint32_t face) {
    return selectedFaces(map, document, selection).contains(face);
}

void selectFace(const FaceMap &map, std::uint32_t face, Vec2 place, Selection &selection) {
    const std::uint32_t marker = map.faces()[face].marker;
    marker != kNoIndex ? void(selection.markers.insert(marker)) : void(selection.faces.insert(place));
}

void deselectFace(const FaceMap &map, const Document &document, std::uint32_t face, Selection &selection) {
    std::erase_if(selection.markers, [&](std::uint32_t k) {
        return k < document.regionMarkers.size() && map.faceOf(document, k) == face;
    });
    std::erase_if(selection.faces, [&](Vec2 place) { return map.faceAt(place) == face; });
}

FaceBorder borderOf(const PickIndex &index, const FaceMap &map, const std::set<std::uint32_t> &faces) {
    FaceBorder border;
    const double tolerance = faces.empty() ? 0.0 : kOnEdge * map.domain()->bounds().diagonal();
    std::set<SegmentRef> parts;
    for (const std::uint32_t face : faces) {
        for (const std::uint32_t e : map.edgesOf(face)) {
            const std::vector<SegmentRef> found = index.segmentsAt(middleOf(map, map.edges()[e]), tolerance);
            parts.insert(found.begin(), found.end());
            border.hiddenEdges += found.empty() ? 1 : 0;
        }
    }
    for (auto first = parts.begin(); first != parts.end();) {
        const Shape &shape = *findShape(index.document(), first->shape);
        const auto end = parts.upper_bound({shape.id, kNoIndex});
        const auto count = static_cast<std::size_t>(std::distance(first, end));
        if (isRound(shape) || count == taggedSegments(shape)) {
            border.lines.shapes.insert(shape.id);
        } else {
            border.lines.segments.insert(first, end);
        }
        if (shape.locked) {
            border.locked.insert(shape.id);
        }
        first = end;
    }
    return border;
}

} // namespace forefront
