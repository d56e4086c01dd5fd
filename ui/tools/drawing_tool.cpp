#include "ui/tools/drawing_tool.hpp"

#include "core/edit/formulas.hpp"
#include "core/edit/join_segments.hpp"
#include "core/edit/shape_commands.hpp"
#include "core/edit/shape_geometry.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/number_text.hpp"
#include "ui/workspace/snap_mark.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace forefront {
namespace {

/// Moves a place that is out of view to where a label beside it can be read.
Vec2 intoView(const Shell &context, Vec2 place) {
    const PixelRect &room = context.view.room;
    const Camera &camera = context.view.camera;
    const double right = room.x + room.width - context.px(200.0), bottom = room.y + room.height - context.px(90.0);
    const Pixel pixel = camera.toPixel(place);
    return camera.toPlane(
        {std::clamp(pixel.x, room.x, std::max(room.x, right)), std::clamp(pixel.y, room.y, std::max(room.y, bottom))});
}

} // namespace

void DrawingTool::follow(const CanvasEvent &event, Shell &context) {
    place_ = event.place;
    modifiers_ = event.modifiers;
    over_ = event.kind != CanvasEvent::Kind::Leave;
    SnapQuery query = state_->query(context, place_, modifiers_.shift() && shiftIsAngle(), modifiers_.control());
    query.anchor = anchor();
    if (query.anchor) {
        query.lines = {*query.anchor};
    }
    query.locks = entry_.locks();
    if (const std::optional<TypedPair> pair = entry_.pair()) {
        pointer_ = lockedAt(typedPlace(*pair));
        return;
    }
    const std::optional<Vec2> own = query.locks.any() || query.off ? std::nullopt : ownSnap(place_, context);
    pointer_ = own ? Snapped{*own, SnapKind::Node} : snap(*state_->index(context), query);
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
        context.selection.clear(); // it is not drawn in this tool, so the menu must not act on it
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
        placeTyped(context);
        follow(event, context);
    }
    return true;
}

/// Places a node at the pointer, and remembers the expressions that were typed for it.
void DrawingTool::placeTyped(Shell &context) {
    const std::optional<TypedPair> pair = entry_.pair();
    TypedNode node{pointer_.at, entry_.expression(EntryField::X), entry_.expression(EntryField::Y)};
    if (pair && !pair->relative) {
        node.x = pair->xText;
        node.y = pair->yText;
    }
    if (!node.x.empty() || !node.y.empty()) {
        typedNodes_.push_back(std::move(node));
    }
    const bool typedNumbers = !entry_.label().empty();
    const std::uint64_t revision = context.document.revision();
    const Vec2 at = pointer_.at;
    place(at, context);
    entry_.clear();
    if (!inProgress()) {
        typedNodes_.clear();
    }
    if (typedNumbers) {
        reveal(at, revision != context.document.revision(), context);
    }
}

/// Brings what was typed into view: the shape that it completed, or the node. What the pointer placed is in view.
void DrawingTool::reveal(Vec2 node, bool completed, Shell &context) const {
    const Selection &drawn = context.selection;
    const Shape *const shape =
        completed && !drawn.shapes.empty() ? findShape(*context.document.current(), *drawn.shapes.begin()) : nullptr;
    context.view.reveal(shape != nullptr ? boundsOf(*shape) : boxOf(node, node));
}

/// Lets the numbers of a shape that were typed follow their expressions. What does not fit, such as a width that the
/// pointer has changed, is removed when the document changes.
void DrawingTool::keepFormulas(Document &document, std::uint32_t shape) const {
    const Shape *const drawn = findShape(document, shape);
    const std::string prefix = "shape/" + std::to_string(shape) + '/';
    const auto keep = [&](const std::string &quantity, const std::string &text) {
        if (!text.empty()) {
            document = setFormula(std::move(document), prefix + quantity, text);
        }
    };
    const bool rectangle = drawn->kind == ShapeKind::Rectangle;
    const std::vector<Vec2> handles = handlesOf(*drawn);
    for (const TypedNode &node : typedNodes_) {
        // Where an end meets its own path, that has a node too: both move together.
        for (std::size_t k = 0; k < handles.size(); ++k) {
            if (handles[k] != node.at) {
                continue;
            }
            const std::string handle = '/' + std::to_string(k);
            if (!rectangle) {
                keep("x" + handle, node.x);
                keep("y" + handle, node.y);
                continue;
            }
            // A rectangle keeps its left and bottom side when its size changes.
            const Vec2 corner = boundsOf(*drawn).min;
            keep("left", node.at.x == corner.x ? node.x : std::string());
            keep("bottom", node.at.y == corner.y ? node.y : std::string());
        }
    }
    const auto half = [](const std::string &text) { return text.empty() ? text : "(" + text + ")/2"; };
    // Plain numbers need no formula. A negative one was typed to go to the left or down.
    const auto extent = [&](EntryField field) {
        const std::string text = entry_.expression(field);
        if (text.empty() || parseNumber(text)) {
            return std::string();
        }
        return entry_.value(field).value_or(0.0) < 0.0 ? "-(" + text + ")" : text;
    };
    const std::string width = extent(EntryField::Width), height = extent(EntryField::Height);
    if (rectangle) {
        keep("width", width);
        keep("height", height);
    } else if (drawn->kind == ShapeKind::Ellipse) {
        keep("rx", half(width));
        keep("ry", half(height));
    } else if (drawn->kind == ShapeKind::Circle) {
        keep("radius", entry_.expression(EntryField::Radius));
    }
}

bool DrawingTool::typed(const CanvasEvent &event, Shell &context) {
    const NumericEntry::Answer answer = entry_.handle(event, entryFields(), context.document.current()->spacing.names);
    if (answer != NumericEntry::Answer::Unused) {
        CanvasEvent here = event;
        here.place = place_;
        here.kind = CanvasEvent::Kind::Hover;
        follow(here, context);
        if (answer == NumericEntry::Answer::Place) {
            placeTyped(context);
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
            discard(context);
            entry_.clear();
            typedNodes_.clear();
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

bool DrawingTool::undo(Shell &) {
    if (!inProgress()) {
        return false;
    }
    if (!removeLast()) {
        cancel();
    }
    return true;
}

void DrawingTool::deactivate(Shell &context) {
    if (inProgress()) {
        finish(context);
    }
    cancel();
    entry_.clear();
    typedNodes_.clear();
    over_ = false;
}

void DrawingTool::forget(Shell &) {
    cancel();
    entry_.clear();
    typedNodes_.clear();
    state_->forgetNumbers();
}

bool DrawingTool::commitShape(Shell &context, Shape shape, const std::string &label) {
    const std::shared_ptr<const Document> before = context.document.current();
    shape.tag = state_->tagOfNext(shape.use, *before);
    Result<Document> next = addShape(*before, std::move(shape));
    if (next) {
        next = joinToSegments(*next, before->nextId);
    }
    if (next) {
        keepFormulas(*next, before->nextId);
    }
    if (!EditState::apply(context, std::move(next), label)) {
        return false;
    }
    context.selection.clear();
    context.selection.shapes.insert(before->nextId);
    entry_.clear();
    typedNodes_.clear();
    return true;
}

void DrawingTool::drawMeasure(CanvasPainter &painter, Shell &context, const std::string &text) const {
    const std::string typedText = entry_.label();
    const Vec2 at = typedText.empty() ? pointer_.at : intoView(context, pointer_.at);
    double y = 14.0;
    if (!text.empty()) {
        painter.label(at, {16.0, y}, text, context.theme.text, fade(context.theme.popup, 0.9), context.fonts.small);
        y += 22.0;
    }
    if (!typedText.empty()) {
        painter.label(at, {16.0, y}, typedText, entry_.isWrong() ? context.theme.bad : context.theme.accent,
                      context.theme.popup, context.fonts.strong);
        y += 24.0;
    }
    if (entry_.isWrong()) {
        painter.label(at, {16.0, y}, entry_.fault(), context.theme.bad, context.theme.popup, context.fonts.small);
    }
}

void DrawingTool::drawOverlay(CanvasPainter &painter, Shell &context) {
    drawSketch(painter, context);
    if (over_) {
        drawSnapMark(painter, context, pointer_);
    }
}

} // namespace forefront
