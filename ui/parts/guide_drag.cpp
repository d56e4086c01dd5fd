#include "ui/parts/guide_drag.hpp"

#include "core/drawing/commands/guide_commands.hpp"
#include "ui/parts/shell.hpp"
#include "ui/workspace/edit_state.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace forefront {

void GuideDrag::beginStroke(Shell &context) {
    stroke_ = "guide " + std::to_string(++strokes_);
    targets_ = std::make_shared<const PickIndex>(context.document.current());
}

void GuideDrag::beginNew(Shell &context, bool upright, Pixel pointer) {
    beginStroke(context);
    const Vec2 place = context.view.camera.toPlane(pointer);
    upright_ = upright;
    fresh_ = true;
    showLayer(context.layers, "guides", true);
    const Document &document = *context.document.current();
    const std::size_t index = document.guides.size();
    if (context.applyCommand(addGuide(document, {upright, upright ? place.x : place.y}), "Add guide", stroke_)) {
        index_ = index;
    }
}

void GuideDrag::begin(Shell &context, std::size_t index) {
    beginStroke(context);
    index_ = index;
    upright_ = context.document.current()->guides[index].upright;
    fresh_ = false;
}

void GuideDrag::update(Shell &context, Pixel pointer, bool off) {
    if (!index_) {
        return;
    }
    if (*index_ >= context.document.current()->guides.size()) { // undone, or another document
        index_.reset();
        targets_.reset();
        return;
    }
    SnapQuery query = EditState().query(context, context.view.camera.toPlane(pointer), false, off);
    query.guides = false; // it would hold itself where it is
    const Vec2 at = snap(*targets_, query).at;
    context.applyCommand(moveGuide(*context.document.current(), *index_, upright_ ? at.x : at.y),
                         fresh_ ? "Add guide" : "Move guide", stroke_);
}

void GuideDrag::finish(Shell &context, Pixel pointer) {
    if (!index_ || *index_ >= context.document.current()->guides.size()) {
        index_.reset();
        return;
    }
    const PixelRect &canvas = context.view.camera.viewport;
    const bool back = upright_ ? pointer.x < canvas.x : pointer.y < canvas.y;
    if (back && fresh_) {
        context.document.abandonStroke(stroke_);
    } else if (back) {
        context.applyCommand(removeGuide(*context.document.current(), *index_), "Remove guide", stroke_);
    }
    context.document.endStroke();
    index_.reset();
    targets_.reset();
    context.animate();
}

void GuideDrag::cancel(Shell &context) {
    if (index_) {
        context.document.abandonStroke(stroke_);
        index_.reset();
        targets_.reset();
    }
}

std::optional<std::size_t> guideAt(const Shell &context, Vec2 place, double reach) {
    if (!showsLayer(context.layers, "guides")) {
        return std::nullopt;
    }
    const std::vector<Guide> &guides = context.document.current()->guides;
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < guides.size(); ++k) {
        const double away = std::fabs(guides[k].at - (guides[k].upright ? place.x : place.y));
        if (away <= reach) {
            reach = away;
            best = k;
        }
    }
    return best;
}

} // namespace forefront
