#include "ui/tools/common/drawing_tool.hpp"

#include "core/drawing/commands/join_segments.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/parse_number.hpp"
#include "ui/workspace/snap_mark.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace forefront {
namespace {

constexpr double kInferenceReach = 200.0; ///< of lines and nodes that relations are found to, design pixels

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
    SnapQuery query =
        state_->query(context, place_, modifiers_.shift() && shiftIsAngle(), modifiers_.control() || !snaps());
    query.gridPitch = snapsToGrid() ? query.gridPitch : 0.0;
    query.anchor = anchor();
    if (query.anchor) {
        query.lines = {*query.anchor};
    }
    query.locks = entry_.locks();
    query.guides = query.guides && showsLayer(context.layers, "guides");
    InferenceQuery infer;
    if (context.snapping.infers && snaps() && describePath(infer)) {
        infer.reach = EditState::reach(context, kInferenceReach);
        query.infer = std::move(infer);
    }
    if (const std::optional<TypedPair> pair = entry_.pair()) {
        pointer_ = lockedAt(fitted(typedPlace(*pair)));
    } else {
        const std::optional<Vec2> own = query.locks.any() || query.off ? std::nullopt : ownSnap(place_, context);
        pointer_ = own ? Snapped{*own, SnapKind::Node} : snap(*state_->index(context), query);
        if (const Vec2 fit = fitted(pointer_.at); fit != pointer_.at) {
            pointer_ = Snapped{fit, SnapKind::None};
        }
    }
    pointed(context);
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
        keepRelations(context);
        place(at, context);
    }
}

bool DrawingTool::press(const CanvasEvent &event, Shell &context) {
    follow(event, context);
    if (event.button == MouseButton::Right && !inProgress()) {
        if (!showsSelection()) {
            context.selection.clear(); // the menu must not act on what is not seen
        }
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
    const PlaceFormula formula = typedFormula(pointer_.at);
    if (!formula.x.empty() || !formula.y.empty()) {
        typedNodes_.push_back({pointer_.at, formula.x, formula.y});
    }
    const bool typedNumbers = !entry_.label().empty();
    const std::uint64_t revision = context.document.revision();
    const Vec2 at = pointer_.at;
    ++state_->placed;
    keepRelations(context);
    place(at, context);
    entry_.clear();
    if (!inProgress()) {
        typedNodes_.clear();
    }
    if (typedNumbers) {
        reveal(at, revision != context.document.revision(), context);
    }
}

void DrawingTool::keepRelations(const Shell &context) {
    if (!inProgress()) {
        inferredNodes_.clear();
    }
    if (context.snapping.addsConstraints && !pointer_.inferred.empty()) {
        InferenceQuery query;
        describePath(query);
        inferredNodes_.push_back({pointer_.at, pointer_.inferred, std::move(query.path)});
    }
}

/// Brings what was typed into view: the shape that it completed, or the node. What the pointer placed is in view.
void DrawingTool::reveal(Vec2 node, bool completed, Shell &context) const {
    const Selection &drawn = context.selection;
    const Shape *const shape =
        completed && !drawn.shapes.empty() ? findShape(*context.document.current(), *drawn.shapes.begin()) : nullptr;
    context.view.reveal(shape != nullptr ? boundsOf(*shape) : boxOf(node, node));
}

PlaceFormula DrawingTool::formulaOf(Vec2 node) const {
    PlaceFormula place = placeFormula(node);
    for (const TypedNode &typed : typedNodes_) {
        if (typed.at == node) {
            place.x = typed.x.empty() ? place.x : typed.x;
            place.y = typed.y.empty() ? place.y : typed.y;
        }
    }
    return place;
}

PlaceFormula DrawingTool::typedFormula(Vec2 at) const {
    const std::optional<TypedPair> pair = entry_.pair();
    const std::optional<Vec2> last = anchor();
    if (pair && (!pair->relative || !last)) {
        return {pair->xText, pair->yText};
    }
    PlaceFormula place{entry_.expression(EntryField::X), entry_.expression(EntryField::Y)};
    if (!last) {
        return place;
    }
    const std::string size = entry_.expression(EntryField::Distance), angle = entry_.expression(EntryField::Angle);
    const bool polar = (!size.empty() || !angle.empty()) && place.x.empty() && place.y.empty();
    if (!pair && !polar) {
        return place;
    }
    const PlaceFormula from = formulaOf(*last);
    place = pair ? PlaceFormula{sumFormula(from.x, pair->xText), sumFormula(from.y, pair->yText)}
                 : polarFormula(from, size.empty() ? exactText(distance(*last, at)) : size,
                                angle.empty() ? degreesText(at - *last) : angle);
    return {usesNames(place.x) ? place.x : "", usesNames(place.y) ? place.y : ""};
}

bool DrawingTool::followsEntry() const {
    const bool coordinate = entry_.value(EntryField::X) || entry_.value(EntryField::Y);
    return !anchor() || !coordinate || !(entry_.value(EntryField::Distance) || entry_.value(EntryField::Angle));
}

void DrawingTool::keepFormulas(const Shape &drawn, const Keep &keep) const {
    const std::vector<Vec2> handles = handlesOf(drawn);
    for (const TypedNode &node : typedNodes_) {
        // Where an end meets its own path, that has a node too: both move together.
        for (std::uint32_t k = 0; k < handles.size(); ++k) {
            if (handles[k] == node.at) {
                keep(Quantity::X, k, node.x);
                keep(Quantity::Y, k, node.y);
            }
        }
    }
}

bool DrawingTool::typed(const CanvasEvent &event, Shell &context) {
    const NumericEntry::Answer answer = entry_.handle(event, entryFields(), context.document.current()->spacing.names,
                                                      ownLetters(), context.document.current()->unit);
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
        if (hasBegun() || !entry_.label().empty()) {
            discard(context);
            entry_.clear();
            typedNodes_.clear();
            return true;
        }
        return false;
    case key::kBackspace:
        return hasBegun() && removeLast();
    default:
        return inProgress() && ownKey(event.key, context);
    }
}

std::span<const EntryField> DrawingTool::entryFields() const {
    static constexpr std::array kPlace{EntryField::X, EntryField::Y};
    static constexpr std::array kDirection{EntryField::Distance, EntryField::Angle};
    return inProgress() ? std::span<const EntryField>(kDirection) : std::span<const EntryField>(kPlace);
}

std::string DrawingTool::typingHint(const Shell &context) const {
    if (!inProgress() || entryFields().empty()) {
        return {};
    }
    return context.document.current()->parameters.empty() ? "= begins a formula"
                                                          : "= or a parameter's name begins a formula";
}

Vec2 DrawingTool::typedPlace(const TypedPair &pair) const {
    return pair.relative && anchor() ? *anchor() + pair.value : pair.value;
}

bool DrawingTool::undo(Shell &) {
    if (!hasBegun()) {
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

namespace {

/// Shows the first shape of a drawing if it can hardly be seen: because it is tiny, or out of view.
void showFirst(Shell &context, const Document &before, const Box2 &box) {
    constexpr double kTiny = 0.05; // of the smaller side of the view
    const Box2 visible = context.view.camera.visible();
    const double extent = std::max(box.size().x, box.size().y);
    const bool tiny = extent < kTiny * std::min(visible.size().x, visible.size().y);
    if (before.shapes.empty() && !before.picture && extent > 0.0 && (tiny || !visible.overlaps(box))) {
        context.view.fit(box);
        context.animate();
    }
}

} // namespace

bool DrawingTool::commitShape(Shell &context, Shape shape, const std::string &label) {
    const std::shared_ptr<const Document> before = context.document.current();
    shape.tag = state_->tagOfDrawn(shape, *before);
    const std::vector<InferredNode> ownRelations = relationsOf(shape);
    Result<Document> next = addShape(*before, std::move(shape));
    if (next) {
        next = joinToSegments(*next, before->nextId);
    }
    if (next) {
        const Shape drawn = *findShape(*next, before->nextId);
        keepFormulas(drawn, [&](Quantity what, std::uint32_t handle, const std::string &formula) {
            if (!formula.empty()) {
                next = setFormula(*std::move(next), {NumberOwner::ofShape(before->nextId), what, handle}, formula);
            }
        });
    }
    std::size_t added = 0;
    if (next && context.snapping.addsConstraints) {
        inferredNodes_.insert(inferredNodes_.end(), ownRelations.begin(), ownRelations.end());
        InferredConstraints constrained = addInferred(*std::move(next), before->nextId, inferredNodes_, *before);
        added = constrained.added;
        next = std::move(constrained.document);
    }
    inferredNodes_.clear();
    if (!context.applyCommand(std::move(next), label)) {
        return false;
    }
    if (added > 0) {
        context.log.announce("Added " + countText(added, "sketch constraint"));
    }
    context.selection.clear();
    context.selection.shapes.insert(before->nextId);
    showFirst(context, *before, boundsOf(*findShape(*context.document.current(), before->nextId)));
    entry_.clear();
    typedNodes_.clear();
    return true;
}

Vec2 DrawingTool::cornerOfBox(Vec2 first, Vec2 at) const {
    const Vec2 arm = at - first;
    const std::optional<double> width = entry_.value(EntryField::Width), height = entry_.value(EntryField::Height);
    if (width || height) {
        // The signs choose the sides, not the pointer: it is where the first corner was clicked, or anywhere.
        return first + Vec2{width.value_or(arm.x), height.value_or(arm.y)};
    }
    if (!modifiers_.shift()) {
        return at;
    }
    const double side = std::max(std::abs(arm.x), std::abs(arm.y));
    return first + Vec2{std::copysign(side, arm.x), std::copysign(side, arm.y)};
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
    if (const std::string prompt = typingPrompt(); !prompt.empty()) {
        painter.label(at, {16.0, y}, prompt, context.theme.muted, context.theme.popup, context.fonts.small);
        y += 22.0;
    }
    if (entry_.isWrong()) {
        painter.label(at, {16.0, y}, entry_.fault(), context.theme.bad, context.theme.popup, context.fonts.small);
    } else if (!followsEntry()) {
        drawUsedOnce(painter, context, entry_, at, y);
    }
}

void DrawingTool::drawOverlay(CanvasPainter &painter, Shell &context) {
    drawSketch(painter, context);
    if (over_ && snaps()) {
        drawSnapMark(painter, context, pointer_);
    }
}

} // namespace forefront
