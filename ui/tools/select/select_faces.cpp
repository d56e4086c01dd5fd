#include "core/drawing/picking/selected_faces.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/select/select_tool.hpp"
#include "ui/workspace/current_faces.hpp"

#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace forefront {

void SelectTool::hitInside(Hit &hit, Shell &context, bool waits) const {
    const SelectionFilter &picks = state_->picks;
    const std::uint32_t shape = picks.shapes ? state_->index(context)->shape(hit.at, 0.0) : kNoIndex;
    waits = waits && context.preview->faces != nullptr; // of large drawings without regions there are none
    hit.faces = !picks.markers ? nullptr : waits ? currentFaces(context) : readyFaces(context);
    hit.face = hit.faces ? hit.faces->faceAt(hit.at) : kNoIndex;
    // A region that is only a part of a shape, such as a county within the outline of its map, is not what the shape
    // is.
    const bool apart = shape != kNoIndex && hit.hasRegion() && !fills(hit, shape);
    if (shape != kNoIndex && !apart) {
        hit.kind = Hit::Kind::Inside;
        hit.shape = shape;
    } else if (hit.face != kNoIndex) {
        hit.kind = Hit::Kind::Face;
    }
}

void SelectTool::takeSelectedFace(Hit &hit, Vec2 place, Shell &context) const {
    if (hit.kind == Hit::Kind::Inside && hit.face != kNoIndex && context.selection.onlyFaces() &&
        isFaceSelected(*hit.faces, *start_, context.selection, hit.face)) {
        hit.kind = Hit::Kind::Face;
        hit.shape = kNoIndex;
        return;
    }
    const bool selected = hit.kind == Hit::Kind::Marker && context.selection.markers.contains(hit.marker);
    if (!selected || distance(hit.at, place) <= EditState::reach(context, 5.0)) {
        return;
    }
    Hit inside;
    inside.at = place;
    hitInside(inside, context, true);
    if (inside.face != kNoIndex && inside.face == inside.faces->faceOf(*start_, hit.marker)) {
        hit = inside;
        hit.kind = Hit::Kind::Face;
        hit.shape = kNoIndex;
    }
}

bool SelectTool::hasFaceWithin(const Hit &hit) const {
    return hit.kind == Hit::Kind::Inside && hit.face != kNoIndex && (hit.hasRegion() || !fills(hit, hit.shape));
}

bool SelectTool::fills(const Hit &hit, std::uint32_t shape) const {
    constexpr double kWhole = 0.99; // the outline of the face is chords
    return signedArea(hit.faces->outlineOf(hit.face)) >=
           kWhole * areaOf(*findShape(state_->lastIndex()->document(), shape));
}

void SelectTool::selectFaceOf(const Hit &hit, bool adds, Selection &selection) const {
    if (!adds) {
        selection.clear();
    }
    if (adds && isFaceSelected(*hit.faces, *start_, selection, hit.face)) {
        deselectFace(*hit.faces, *start_, hit.face, selection);
    } else {
        selectFace(*hit.faces, hit.face, hit.at, selection);
    }
}

void SelectTool::pointAtFace(Shell &context) const {
    const std::vector<MarkedRegion> &markers = context.document.current()->regionMarkers;
    const bool marker = over_ && hover_.kind == Hit::Kind::Marker && hover_.marker < markers.size();
    const bool face = over_ && hover_.kind == Hit::Kind::Face && (mode_ == Mode::Idle || mode_ == Mode::Grabbed);
    context.view.facePlace = marker ? std::optional(markers[hover_.marker].at)
                             : face ? std::optional(hover_.at)
                                    : std::nullopt;
}

bool SelectTool::beginFaceMove(Shell &context) {
    const FaceMap &map = *grabbed_.faces;
    Result<FaceMove> move = FaceMove::of(*startIndex_, map, selectedFaces(map, *start_, context.selection));
    if (!move) {
        context.log.add(move.faults());
        return false;
    }
    faceMove_ = *std::move(move);
    startFaces_ = context.selection.faces;
    Selection parts = faceMove_->parts();
    moving_.shapes.merge(parts.shapes);
    moving_.segments.merge(parts.segments);
    moving_.sources.merge(parts.sources);
    moving_.markers.merge(parts.markers);
    return true;
}

void SelectTool::followFaces(Shell &context, Vec2 by) const {
    if (!faceMove_) {
        return;
    }
    context.selection.faces.clear();
    for (const Vec2 place : startFaces_) {
        context.selection.faces.insert(place + by);
    }
}

void SelectTool::abandonMove(Shell &context) {
    context.document.abandonStroke(stroke_);
    followFaces(context, {});
}

} // namespace forefront
