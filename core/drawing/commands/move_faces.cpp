#include "core/drawing/commands/move_faces.hpp"

#include "core/drawing/arrangement/assembly/face_points.hpp"
#include "core/drawing/commands/carry_joints.hpp"
#include "core/drawing/picking/selected_faces.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

namespace forefront {
namespace {

/// Returns true if p lies between the edges by the even-odd rule.
bool liesBetween(const std::vector<FaceEdge> &edges, Vec2 p) {
    bool inside = false;
    for (const FaceEdge &edge : edges) {
        if ((edge.a.x <= p.x) != (edge.b.x <= p.x)) {
            const double t = (p.x - edge.a.x) / (edge.b.x - edge.a.x);
            inside = inside != (edge.a.y + t * (edge.b.y - edge.a.y) > p.y);
        }
    }
    return inside;
}

Diagnostics lockedBorder(const Document &document, std::uint32_t id) {
    return error("border-locked",
                 "cannot move the face: " + displayName(*findShape(document, id)) + " on its border is locked",
                 "unlock it");
}

/// Returns the first curve of a part of an outline.
std::optional<Curve> curveOfPart(const Outline &outline, std::uint32_t part) {
    for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
        if (outline.part(k) == part) {
            return outline.curve(k);
        }
    }
    return std::nullopt;
}

/// Returns the parameter of the place on a part of an outline that is nearest to p.
double alongOutline(const Outline &outline, std::uint32_t part, Vec2 p) {
    const std::optional<Curve> curve = curveOfPart(outline, part);
    return curve ? curve->nearest(p) : 0.0;
}

} // namespace

Result<FaceMove> FaceMove::of(const PickIndex &index, const FaceMap &map, const std::set<std::uint32_t> &faces) {
    if (faces.empty()) {
        return error("no-face", "no face to move", "click inside a face of the domain");
    }
    const FaceBorder border = borderOf(index, map, faces);
    if (!border.locked.empty()) {
        return lockedBorder(index.document(), *border.locked.begin());
    }
    if (border.hiddenEdges > 0) {
        return error("border-hidden", "cannot move the face: a shape on its border is hidden", "show all shapes");
    }
    FaceMove move;
    move.parts_ = border.lines;
    move.takeParts(index, map, faces);
    move.takeNeighbours(index, map, faces);
    return move;
}

/// Adds what lies inside of the faces, also in their holes, and the markers of the faces.
void FaceMove::takeParts(const PickIndex &index, const FaceMap &map, const std::set<std::uint32_t> &faces) {
    for (const std::uint32_t face : faces) {
        Selection inside = index.inLoop(map.outlineOf(face), false);
        parts_.shapes.merge(inside.shapes);
        parts_.sources.merge(inside.sources);
        parts_.markers.merge(inside.markers);
    }
    std::erase_if(parts_.segments, [&](const SegmentRef &segment) { return parts_.shapes.contains(segment.shape); });
}

/// Notes the faces that touch the border and have markers that do not move.
void FaceMove::takeNeighbours(const PickIndex &index, const FaceMap &map, const std::set<std::uint32_t> &faces) {
    std::vector<Vec2> moving;
    for (const std::uint32_t face : faces) {
        for (const std::uint32_t e : map.edgesOf(face)) {
            moving.insert(moving.end(), {map.edges()[e].a, map.edges()[e].b});
        }
    }
    std::sort(moving.begin(), moving.end(), comesBefore);
    const auto moves = [&](Vec2 p) { return std::binary_search(moving.begin(), moving.end(), p, comesBefore); };
    std::map<std::uint32_t, ChangedFace> changed;
    for (const MappedEdge &edge : map.edges()) {
        if (moves(edge.a) || moves(edge.b)) {
            changed[edge.left];
            changed[edge.right];
        }
    }
    for (std::uint32_t k = 0; k < index.document().regionMarkers.size(); ++k) {
        const auto found = parts_.markers.contains(k) ? changed.end() : changed.find(map.faceOf(index.document(), k));
        if (found != changed.end() && found->first != kNoIndex && !faces.contains(found->first)) {
            found->second.markers.push_back(k);
        }
    }
    std::map<Vec2, std::uint32_t, PlaceOrder> numbers;
    const double near = 1e-6 * (map.domain() != nullptr ? map.domain()->bounds().diagonal() : 0.0);
    const auto anchor = [&](Vec2 p) {
        const auto [place, fresh] = numbers.emplace(p, static_cast<std::uint32_t>(anchors_.size()));
        if (fresh) {
            Anchor made{p};
            if (const std::optional<NodeHit> node = index.node(p, near)) {
                made.shape = node->ref.shape;
                made.part = node->ref.node;
            } else if (const std::optional<SegmentHit> segment = index.segment(p, near)) {
                const Shape &shape = *findShape(index.document(), segment->ref.shape);
                made = {p, shape.id, segment->ref.segment, alongOutline(outlineOf(shape), segment->ref.segment, p),
                        true};
            }
            anchors_.push_back(made);
        }
        return place->second;
    };
    for (auto &[face, neighbour] : changed) {
        if (neighbour.markers.empty()) {
            continue;
        }
        for (const std::uint32_t e : map.edgesOf(face)) {
            const std::uint32_t from = anchor(map.edges()[e].a);
            neighbour.edges.emplace_back(from, anchor(map.edges()[e].b));
        }
        neighbours_.push_back(std::move(neighbour));
    }
}

/// Returns where the anchors are after the move.
std::vector<Vec2> FaceMove::placesIn(const Document &after) const {
    struct Where {
        std::vector<Vec2> handles;
        Outline outline;
    };
    std::map<std::uint32_t, Where> shapes;
    std::vector<Vec2> places;
    places.reserve(anchors_.size());
    for (const Anchor &anchor : anchors_) {
        const auto [found, fresh] = shapes.try_emplace(anchor.shape);
        Where &where = found->second;
        if (const Shape *const shape = fresh ? findShape(after, anchor.shape) : nullptr) {
            where = {handlesOf(*shape), outlineOf(*shape)};
        }
        const std::optional<Curve> curve = anchor.onSegment ? curveOfPart(where.outline, anchor.part) : std::nullopt;
        const bool node = !anchor.onSegment && anchor.part < where.handles.size();
        places.push_back(node ? where.handles[anchor.part] : curve ? curve->point(anchor.t) : anchor.at);
    }
    return places;
}

Document FaceMove::keepMarkers(Document after) const {
    const std::vector<Vec2> places = placesIn(after);
    std::vector<FaceEdge> edges;
    for (const ChangedFace &face : neighbours_) {
        edges.clear();
        for (const auto &[from, to] : face.edges) {
            edges.push_back({places[from], places[to]});
        }
        for (const std::uint32_t marker : face.markers) {
            Vec2 &at = after.regionMarkers[marker].at;
            if (!liesBetween(edges, at)) {
                at = pointInFace(edges).value_or(at);
            }
        }
    }
    return after;
}

Result<Document> moveFaces(const PickIndex &index, const FaceMap &map, const std::set<std::uint32_t> &faces, Vec2 by) {
    const Result<FaceMove> move = FaceMove::of(index, map, faces);
    if (!move) {
        return move.faults();
    }
    const Result<Document> moved = moveSelection(index.document(), move->parts(), by);
    if (!moved) {
        return moved;
    }
    Result<Document> carried = carryJoints(index.document(), *moved);
    return carried ? Result<Document>(move->keepMarkers(*std::move(carried))) : carried;
}

} // namespace forefront
