#include "ui/tools/drawing_tool.hpp"

#include "core/edit/join_segments.hpp"
#include "core/edit/shape_commands.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"

#include <array>

namespace forefront {

void DrawingTool::follow(const CanvasEvent &event, Shell &context) {
    place_ = event.place;
    modifiers_ = event.modifiers;
    over_ = event.kind != CanvasEvent::Kind::Leave;
    SnapQuery query = state_->query(context, place_, modifiers_.shift() && shiftIsAngle(), modifiers_.control());
    query.anchor = anchor();
    query.locks = entry_.locks();
    if (const std::optional<TypedPair> pair = entry_.pair()) {
        pointer_ = {typedPlace(*pair), SnapKind::Locked, {}};
        return;
    }
    const std::optional<Vec2> own = query.locks.any() || query.off ? std::nullopt : ownSnap(place_, context);
    pointer_ = own ? Snapped{*own, SnapKind::Node, {}} : snap(*state_->index(context), query);
}

bool DrawingTool::handle(const CanvasEvent &event, Shell &context) {
    using Kind = CanvasEvent::Kind;
    switch (event.kind) {
    case Kind::Drag:
        follow(event, context);
        if (inProgress() && glm::distance(event.pixel, pressPixel_) > static_cast<double>(context.px(5))) {
            pull(pointer_.at);
        }
        return true;
    case Kind::Hover:
    case Kind::Leave:
        follow(event, context);
        return true;
    case Kind::Press:
        return press(event, context);
    case Kind::Release:
        follow(event, context);
        if (event.button == MouseButton::Left && inProgress()) {
            const bool away = glm::distance(event.pixel, pressPixel_) > static_cast<double>(context.px(5));
            release(pointer_.at, away, context);
        }
        return true;
    case Kind::Key:
    case Kind::Text:
        return typed(event, context);
    case Kind::Wheel:
        break;
    }
    return false;
}

void DrawingTool::release(Vec2 at, bool away, Shell &context) {
    if (away && dragPlaces()) {
        place(at, context);
    }
}

bool DrawingTool::press(const CanvasEvent &event, Shell &context) {
    follow(event, context);
    if (event.button == MouseButton::Right && !inProgress()) {
        context.contextMenu = true;
        return true;
    }
    if (event.button == MouseButton::Right ||
        (event.button == MouseButton::Left && event.clicks == 2 && inProgress())) {
        finish(context);
        return true;
    }
    if (event.button == MouseButton::Left) {
        pressPixel_ = event.pixel;
        place(pointer_.at, context);
        entry_.clear();
        follow(event, context);
    }
    return true;
}

bool DrawingTool::typed(const CanvasEvent &event, Shell &context) {
    const NumericEntry::Answer answer = entry_.handle(event, entryFields());
    if (answer != NumericEntry::Answer::Unused) {
        CanvasEvent here = event;
        here.place = place_;
        here.kind = CanvasEvent::Kind::Hover;
        follow(here, context);
        if (answer == NumericEntry::Answer::Place) {
            place(pointer_.at, context);
            entry_.clear();
            follow(here, context);
        }
        return true;
    }
    if (event.kind != CanvasEvent::Kind::Key || event.modifiers.control()) {
        return false;
    }
    switch (event.key) {
    case key::kEnter:
    case key::kKeypadEnter:
        if (inProgress()) {
            finish(context);
            return true;
        }
        return false;
    case key::kEscape:
        if (inProgress() || !entry_.label().empty()) {
            cancel();
            entry_.clear();
            return true;
        }
        return false;
    case key::kBackspace:
        return inProgress() && removeLast();
    default:
        return false;
    }
}

std::span<const EntryField> DrawingTool::entryFields() const {
    static constexpr std::array kPlace{EntryField::X, EntryField::Y};
    static constexpr std::array kDirection{EntryField::Distance, EntryField::Angle};
    return inProgress() ? std::span<const EntryField>(kDirection) : std::span<const EntryField>(kPlace);
}

Vec2 DrawingTool::typedPlace(const TypedPair &pair) const {
    return pair.relative && anchor() ? *anchor() + pair.value : pair.value;
}

void DrawingTool::deactivate(Shell &context) {
    if (inProgress()) {
        finish(context);
    }
    cancel();
    entry_.clear();
    over_ = false;
}

bool DrawingTool::commitShape(Shell &context, Shape shape, const std::string &label) {
    const std::shared_ptr<const Document> before = context.document.current();
    shape.tag = shape.use == ShapeUse::Boundary ? state_->boundaryTag : state_->constraintTag;
    Result<Document> next = addShape(*before, std::move(shape));
    if (next) {
        next = joinToSegments(*next, before->nextId);
    }
    if (!EditState::apply(context, std::move(next), label)) {
        return false;
    }
    context.selection.clear();
    context.selection.shapes.insert(before->nextId);
    entry_.clear();
    return true;
}

void DrawingTool::drawMeasure(CanvasPainter &painter, Shell &context, const std::string &text) const {
    const std::string typedText = entry_.label();
    double y = 14.0;
    if (!text.empty()) {
        painter.label(pointer_.at, {16.0, y}, text, context.theme.text, fade(context.theme.popup, 0.9),
                      context.fonts.small);
        y += 22.0;
    }
    if (!typedText.empty()) {
        painter.label(pointer_.at, {16.0, y}, typedText, entry_.isWrong() ? context.theme.bad : context.theme.accent,
                      context.theme.popup, context.fonts.strong);
    }
}

void DrawingTool::drawOverlay(CanvasPainter &painter, Shell &context) {
    drawSketch(painter, context);
    if (over_) {
        drawSnapMark(painter, context, pointer_);
    }
}

} // namespace forefront
