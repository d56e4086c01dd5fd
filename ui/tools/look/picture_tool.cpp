#include "ui/tools/look/picture_tool.hpp"

#include "core/drawing/commands/scale_document.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/enum_choice.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"
#include "ui/workspace/picture_view.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace forefront {

namespace {

constexpr float kPlaceField = 82.0F; ///< width in design pixels: a coordinate of seven digits

/// Draws a field for a length, or for an angle, with a short label. Returns true when it was changed.
bool drawPlaceField(Shell &context, ui::Flow &flow, const char *name, const char *label, double &value,
                    const char *tooltip, bool angle = false) {
    flow.item(name);
    flow.name(label);
    const LengthUnit unit = angle ? LengthUnit::None : context.document.current()->unit;
    const bool changed = ui::inputNumber(context, name, value, kPlaceField, {}, unit);
    ui::tooltip(context, tooltip);
    return changed;
}

/// Fits the picture into the view, unless all of it is there: coordinates may have taken it anywhere.
void showWhole(Shell &context) {
    const Box2 box = boundsOf(*context.document.current()->picture), visible = context.view.camera.visible();
    if (!visible.contains(box.min) || !visible.contains(box.max)) {
        context.view.fit(box);
        context.animate();
    }
}

} // namespace

const char *PictureTool::icon() const {
    return icon::kPicture;
}

const BackgroundPicture *PictureTool::movable(const Shell &context) {
    const std::optional<BackgroundPicture> &picture = context.document.current()->picture;
    return picture && !picture->locked ? &*picture : nullptr;
}

Vec2 PictureTool::place(const BackgroundPicture &picture, std::size_t point) const {
    return placeIn(picture, points_[point]);
}

Vec2 PictureTool::share(const BackgroundPicture &picture, Vec2 place) {
    return shareOf(picture, place);
}

void PictureTool::change(Shell &context, const BackgroundPicture &picture, const std::string &label,
                         const std::string &stroke) const {
    const std::shared_ptr<const Document> before = context.document.current();
    Document next = *before;
    next.picture = picture;
    context.document.apply(std::move(next), label, stroke);
    keepPictureInView(context, *before);
}

bool PictureTool::handle(const CanvasEvent &event, Shell &context) {
    using Kind = CanvasEvent::Kind;
    switch (event.kind) {
    case Kind::Press:
        return event.button == MouseButton::Left && press(event.place, context);
    case Kind::Drag:
        drag(event.place, context);
        return true;
    case Kind::Release:
        context.document.endStroke();
        stroke_.clear();
        if (held_ && points_.size() == 2) {
            context.widgets.fields.request("options/picture/distance");
            context.animate();
        }
        held_.reset();
        return true;
    case Kind::Key:
        return !event.modifiers.control() && key(event.key);
    default:
        return false;
    }
}

bool PictureTool::press(Vec2 at, Shell &context) {
    const BackgroundPicture *const picture = movable(context);
    if (picture == nullptr || !covers(*picture, at)) {
        return false;
    }
    if (mode_ == PictureMode::Calibrate) {
        pressPoint(at, context);
    } else {
        stroke_ = state_->newStroke();
        grip_ = at - picture->corner;
    }
    return true;
}

/// Takes hold of the point under the pointer, or places the next one there.
void PictureTool::pressPoint(Vec2 at, Shell &context) {
    const BackgroundPicture &picture = *movable(context);
    for (std::size_t k = 0; k < points_.size() && !held_; ++k) {
        if (distance(place(picture, k), at) <= EditState::reach(context, 8.0)) {
            held_ = k;
        }
    }
    if (held_) {
        return;
    }
    if (points_.size() == 2) {
        points_.clear();
        scaleDrawing_.reset();
        firstPlaced_ = false;
    }
    points_.push_back(share(picture, at));
    held_ = points_.size() - 1;
}

void PictureTool::drag(Vec2 to, Shell &context) {
    const BackgroundPicture *const picture = movable(context);
    if (picture == nullptr) {
        return;
    }
    if (held_) {
        const std::size_t other = 1 - *held_;
        // Points in one place have no distance to calibrate.
        if (other >= points_.size() || distance(place(*picture, other), to) > EditState::reach(context, 2.0)) {
            points_[*held_] = share(*picture, to);
        }
    } else if (!stroke_.empty()) {
        BackgroundPicture moved = *picture;
        moved.corner = to - grip_;
        change(context, moved, "Move background picture", stroke_);
    }
}

bool PictureTool::key(int code) {
    if (points_.empty() || mode_ != PictureMode::Calibrate) {
        return false;
    }
    if (code == key::kEscape) {
        points_.clear();
        return true;
    }
    if (code == key::kBackspace) {
        points_.pop_back();
        return true;
    }
    return false;
}

bool PictureTool::undo(Shell &) {
    const bool unfinished = points_.size() == 1;
    if (unfinished) {
        points_.clear();
    }
    return unfinished;
}

void PictureTool::deactivate(Shell &context) {
    context.document.endStroke();
    stroke_.clear();
    held_.reset();
    points_.clear();
    scaleDrawing_.reset();
    firstPlaced_ = false;
    mode_ = PictureMode::Move;
}

bool PictureTool::scalesDrawing(const Shell &context) const {
    const Document &document = *context.document.current();
    return !document.shapes.empty() && scaleDrawing_.value_or(boundsOf(document).overlaps(boundsOf(*document.picture)));
}

void PictureTool::calibrate(Shell &context, double distance) const {
    const std::shared_ptr<const Document> before = context.document.current();
    const Vec2 first = place(*before->picture, 0);
    const double factor = distance / forefront::distance(first, place(*before->picture, 1));
    // The picture stays at its corner, unless the user has placed the first point, or it lies on a drawing that stays.
    const bool corner = !firstPlaced_ && (before->shapes.empty() || scalesDrawing(context));
    const Vec2 fixed = corner ? before->picture->corner : first;
    if (!scalesDrawing(context)) {
        change(context, scaledAbout(*before->picture, fixed, factor), "Calibrate background picture");
        return;
    }
    if (context.applyCommand(scaleDocument(*before, fixed, factor), "Calibrate picture and drawing")) {
        keepPictureInView(context, *before);
        if (before->spacing.expression) {
            context.log.announce("The drawing is scaled; the spacing expression is not");
        }
    }
}

void PictureTool::drawPlace(Shell &context, ui::Flow &flow) {
    BackgroundPicture picture = *context.document.current()->picture;
    bool moved = drawPlaceField(context, flow, "options/picture/x", "x", picture.corner.x,
                                "x of the lower left corner of the picture");
    moved = drawPlaceField(context, flow, "options/picture/y", "y", picture.corner.y,
                           "y of the lower left corner of the picture") ||
            moved;
    double width = picture.size.x;
    if (drawPlaceField(context, flow, "options/picture/width", "Width", width,
                       "Width of the picture; its height follows") &&
        ui::checkPositive(context, "options/picture/width", width)) {
        change(context, scaledAbout(picture, picture.corner, width / picture.size.x), "Scale background picture");
    } else if (moved) {
        change(context, picture, "Move background picture");
    }
    double angle = picture.angle;
    if (drawPlaceField(context, flow, "options/picture/angle", "Angle", angle,
                       "Angle of the picture in degrees, counter-clockwise about its lower left corner", true)) {
        picture.angle = std::remainder(angle, 360.0);
        change(context, picture, "Rotate background picture");
    }
}

void PictureTool::drawCalibration(Shell &context, ui::Flow &flow) {
    BackgroundPicture picture = *context.document.current()->picture;
    if (points_.size() < 2) {
        flow.item("picture/ask");
        ImGui::AlignTextToFramePadding();
        ui::muted(context, points_.empty() ? "Click two points whose distance you know" : "Click the second point");
        return;
    }
    const Vec2 first = place(picture, 0);
    double length = distance(first, place(picture, 1));
    if (drawPlaceField(context, flow, "options/picture/distance", "Distance", length,
                       "Real distance between the two points") &&
        ui::checkPositive(context, "options/picture/distance", length)) {
        calibrate(context, length);
    }
    if (!context.document.current()->shapes.empty()) {
        flow.item("picture/scaledrawing");
        bool scales = scalesDrawing(context);
        if (ui::checkbox(context, "options/picture/scaledrawing", "Scale the drawing, too", scales)) {
            scaleDrawing_ = scales;
        }
        ui::tooltip(context, "The drawing and its element sizes keep their place on the picture");
    }
    Vec2 wanted = first;
    bool moved = drawPlaceField(context, flow, "options/picture/x1", "x1", wanted.x,
                                "Where the first point is in the drawing: x");
    moved = drawPlaceField(context, flow, "options/picture/y1", "y1", wanted.y,
                           "Where the first point is in the drawing: y") ||
            moved;
    if (moved) {
        picture.corner += wanted - first;
        firstPlaced_ = true;
        change(context, picture, "Move background picture");
        showWhole(context);
    }
    drawSecondPlace(context, flow);
}

/// Draws the coordinates of the second point, which turn and scale the picture about the first one.
void PictureTool::drawSecondPlace(Shell &context, ui::Flow &flow) {
    const BackgroundPicture picture = *context.document.current()->picture;
    const Vec2 first = place(picture, 0);
    Vec2 second = place(picture, 1);
    bool moved = drawPlaceField(context, flow, "options/picture/x2", "x2", second.x,
                                "Where the second point is in the drawing: x. The picture is turned and scaled about "
                                "the first point; the drawing stays");
    moved = drawPlaceField(context, flow, "options/picture/y2", "y2", second.y,
                           "Where the second point is in the drawing: y. The picture is turned and scaled about the "
                           "first point; the drawing stays") ||
            moved;
    if (moved && distance(first, second) <= 1e-12 * std::max(length(first), length(second))) {
        const std::string fault = "expected another place than that of the first point";
        ui::refuseEntry(context, "options/picture/x2", error("bad-number", fault), fault);
    } else if (moved) {
        firstPlaced_ = true;
        change(context, placedBy(picture, points_[0], points_[1], first, second), "Place background picture");
        showWhole(context);
    }
}

void PictureTool::drawLook(Shell &context, ui::Flow &flow) {
    BackgroundPicture picture = *context.document.current()->picture;
    flow.item("picture/opacity");
    flow.label("Opacity");
    double percent = 100.0 * picture.opacity;
    if (ui::slider(context, "options/picture/opacity", percent, 0.0, 100.0, "%.0f %%", false, 84.0F)) {
        stroke_ = stroke_.empty() ? state_->newStroke() : stroke_;
        picture.opacity = percent / 100.0;
        change(context, picture, "Change opacity of background picture", stroke_);
    }
    if (ImGui::IsItemDeactivated()) {
        context.document.endStroke();
        stroke_.clear();
    }
    ui::tooltip(context, "Opacity of the picture");
    flow.item("picture/show");
    if (LayerSlot *const layer = context.layer("picture")) {
        bool visible = layer->visible;
        if (ui::checkbox(context, "options/picture/show", "Show", visible)) {
            showLayer(context.layers, "picture", visible);
            context.animate();
        }
    }
    ImGui::SameLine(0, context.px(12));
    if (ui::checkbox(context, "options/picture/lock", "Lock", picture.locked)) {
        change(context, picture, picture.locked ? "Lock background picture" : "Unlock background picture");
    }
    ui::tooltip(context, "A locked picture is neither moved nor scaled");
    flow.item("picture/replace");
    if (ui::button(context, "options/picture/replace", "Replace\xe2\x80\xa6")) {
        context.actions.run("file.addPicture", context);
    }
    ui::tooltip(context, "Choose another file; it keeps the place and scale");
    flow.item("picture/remove");
    if (ui::button(context, "options/picture/remove", "Remove")) {
        Document next = *context.document.current();
        next.picture.reset();
        context.document.apply(std::move(next), "Remove background picture");
    }
}

void PictureTool::drawOptions(Shell &context, ui::Flow &flow) {
    if (!context.document.current()->picture) {
        points_.clear();
        flow.item("picture/add");
        if (ui::button(context, "options/picture/add", "Add picture\xe2\x80\xa6")) {
            context.actions.run("file.addPicture", context);
        }
        return;
    }
    if (movable(context) != nullptr) {
        flow.item("picture/mode");
        if (ui::segmented(context, "options/picture/mode", mode_, 150.0F)) {
            points_.clear();
        }
        ui::tooltip(context, "Move: drag the picture. Calibrate: click two points and enter their real "
                             "distance, or the coordinates of both.");
        mode_ == PictureMode::Move ? drawPlace(context, flow) : drawCalibration(context, flow);
    }
    drawLook(context, flow);
}

void PictureTool::drawOverlay(CanvasPainter &painter, Shell &context) {
    const BackgroundPicture *const picture = movable(context);
    if (picture == nullptr) {
        return;
    }
    const Theme &theme = context.theme;
    painter.polyline(cornersOf(*picture), true, fade(theme.selection, 0.7), 1.0);
    if (mode_ != PictureMode::Calibrate || points_.empty()) {
        return;
    }
    const Vec2 first = place(*picture, 0);
    if (points_.size() == 2) {
        const Vec2 second = place(*picture, 1);
        painter.line(first, second, theme.selection, 1.5);
        painter.label(midpoint(first, second), {10.0, 8.0}, ui::number(distance(first, second)), theme.text,
                      fade(theme.popup, 0.9), context.fonts.small);
    } else if (context.view.pointer) {
        painter.dashed(first, *context.view.pointer, fade(theme.selection, 0.7), 1.5);
    }
    for (std::size_t k = 0; k < points_.size(); ++k) {
        const Vec2 at = place(*picture, k);
        painter.cross(at, 7.0, theme.canvas, 4.0);
        painter.cross(at, 7.0, theme.selection, 2.0);
        painter.label(at, {10.0, -24.0}, k == 0 ? "1" : "2", theme.text, fade(theme.popup, 0.9), context.fonts.small);
    }
}

CursorShape PictureTool::cursor() const {
    return mode_ == PictureMode::Calibrate ? CursorShape::Crosshair : CursorShape::Move;
}

std::string PictureTool::statusText(const Shell &context) const {
    const std::optional<BackgroundPicture> &picture = context.document.current()->picture;
    if (!picture) {
        return "Add a picture to trace, or drop a PNG or JPEG file onto the window";
    }
    if (picture->locked) {
        return "The picture is locked; unlock it to move or scale it";
    }
    if (mode_ == PictureMode::Move) {
        return "Drag the picture, or choose Calibrate to set its scale by two points";
    }
    switch (points_.size()) {
    case 0:
        return "Click the first of two points whose distance you know";
    case 1:
        return "Click the second point. Esc: start again";
    default:
        return "In the fields above, enter the real distance between the points, or the coordinates of both. Drag a "
               "point to correct it; Esc: start again";
    }
}

} // namespace forefront
