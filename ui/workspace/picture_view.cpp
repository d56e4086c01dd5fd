#include "ui/workspace/picture_view.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/workspace/workspace.hpp"

namespace forefront {

namespace {

/// Returns true if nothing is drawn, or the drawing was scaled with the picture.
bool keptOnPicture(const Document &before, const Document &now) {
    const Box2 drawn = boundsOf(before), drawnNow = boundsOf(now);
    if (drawn.empty() || drawnNow.empty()) {
        return drawnNow.empty();
    }
    const double factor = now.picture->size.x / before.picture->size.x;
    const auto moved = [&](Vec2 place) { return now.picture->corner + factor * (place - before.picture->corner); };
    const double close = 1e-6 * now.picture->size.x;
    return distance(moved(drawn.min), drawnNow.min) <= close && distance(moved(drawn.max), drawnNow.max) <= close;
}

} // namespace

void keepPictureInView(Workspace &context, const Document &before) {
    const std::shared_ptr<const Document> now = context.document.current();
    const bool scaled = before.picture && now->picture && before.picture->size.x != now->picture->size.x;
    if (scaled && keptOnPicture(before, *now)) {
        context.view.rescale(boundsOf(*before.picture), boundsOf(*now->picture));
        context.animate();
    }
}

} // namespace forefront
