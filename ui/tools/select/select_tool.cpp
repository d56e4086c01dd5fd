#include "ui/tools/select/select_tool.hpp"

#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/shapes/groups.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/parts/shell.hpp"
#include "ui/workspace/current_faces.hpp"
#include "ui/workspace/joined_command.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace forefront {

const char *SelectTool::icon() const {
    return icon::kSelect;
}

CursorShape SelectTool::cursor() const {
    if (mode_ == Mode::Moving) {
        return CursorShape::Move;
    }
    const bool grabs = over_ && !hover_.isFree();
    return grabs && mode_ != Mode::Boxing ? CursorShape::Hand : CursorShape::Arrow;
}

void SelectTool::endDrag() {
    mode_ = Mode::Idle;
    transform_.end();
    start_.reset();
    startIndex_.reset();
    startJoints_.reset();
    startConstraints_.reset();
    aloneConstraints_.reset();
    heldBy_.reset();
    faceMove_.reset();
}

void SelectTool::deactivate(Shell &context) {
    guide_.cancel(context);
    over_ = false;
    endDrag();
    pointAtFace(context);
}

namespace {

template <class T>
void choose(std::set<T> &set, const T &item, bool toggles) {
    if (toggles && set.erase(item) > 0) {
        return;
    }
    set.insert(item);
}

} // namespace

void SelectTool::selectShape(std::uint32_t shape, bool adds, Selection &selection) const {
    const bool removes = adds && selection.shapes.contains(shape);
    for (const std::uint32_t member : single_ ? std::set{shape} : shapesGroupedWith(*start_, shape)) {
        removes ? void(selection.shapes.erase(member)) : void(selection.shapes.insert(member));
        selection.sides.erase(member);
    }
}

void SelectTool::select(const Hit &hit, bool adds, Selection &selection) const {
    if (hit.kind == Hit::Kind::Control || hit.kind == Hit::Kind::Transform) {
        return;
    }
    // Beside a selected segment, another segment of the shape is meant.
    const bool segment = hit.kind == Hit::Kind::Segment && !selection.segments.empty() && selection.shapes.empty() &&
                         std::all_of(selection.segments.begin(), selection.segments.end(),
                                     [&](const SegmentRef &chosen) { return adds || chosen.shape == hit.shape; });
    // Beside selected regions, another region is meant.
    if (hit.kind == Hit::Kind::Face ||
        (hit.kind == Hit::Kind::Inside && adds && selection.onlyFaces() && hit.hasRegion())) {
        selectFaceOf(hit, adds, selection);
        return;
    }
    if (!adds) {
        selection.clear();
    }
    switch (hit.kind) {
    case Hit::Kind::Node: {
        // A point shape has one node.
        const Shape *shape = findShape(*start_, hit.shape);
        // Beside whole shapes, another shape is meant.
        const bool beside = adds && selection.nodes.empty() && !selection.shapes.empty() &&
                            (selection.shapes.size() > 1 || !selection.touches(hit.shape));
        if (beside || (shape != nullptr && shape->is<PointForm>())) {
            selectShape(hit.shape, adds, selection);
        } else {
            choose(selection.nodes, hit.node, adds);
        }
        break;
    }
    case Hit::Kind::Source:
        choose(selection.sources, hit.source.source, adds);
        break;
    case Hit::Kind::Marker:
        choose(selection.markers, hit.marker, adds);
        break;
    case Hit::Kind::Constraint:
        choose(selection.constraints, hit.constraint, adds);
        break;
    case Hit::Kind::Segment:
        if (segment) {
            choose(selection.segments, hit.segment->ref, adds);
        } else {
            selectShape(hit.shape, adds, selection);
            selection.sides[hit.shape] = hit.segment->ref.segment;
        }
        break;
    case Hit::Kind::Inside:
        selectShape(hit.shape, adds, selection);
        break;
    case Hit::Kind::Control:
    case Hit::Kind::Transform:
    case Hit::Kind::Guide:
    case Hit::Kind::Face:
    case Hit::Kind::Nothing:
        break;
    }
}

bool SelectTool::handle(const CanvasEvent &event, Shell &context) {
    using Kind = CanvasEvent::Kind;
    switch (event.kind) {
    case Kind::Hover:
        over_ = true;
        hover_ = hitAt(event.place, context);
        pointAtFace(context);
        return true;
    case Kind::Leave:
        over_ = false;
        pointAtFace(context);
        return true;
    case Kind::Press:
        if (event.button == MouseButton::Left) {
            press(event, context);
        } else if (event.button == MouseButton::Right) {
            openMenu(event, context);
        }
        return true;
    case Kind::Drag:
        drag(event, context);
        return true;
    case Kind::Release:
        release(event, context);
        return true;
    case Kind::Key:
        return transform_.typed(event, context) || typedMove(event, context) || key(event, context);
    case Kind::Text:
        return transform_.typed(event, context) || typedMove(event, context);
    case Kind::Wheel:
        break;
    }
    return false;
}

void SelectTool::press(const CanvasEvent &event, Shell &context) {
    over_ = true;
    start_ = context.document.current();
    startIndex_ = state_->index(context);
    grabbed_ = hitAt(event.place, context, true);
    takeSelectedFace(grabbed_, event.place, context);
    hover_ = grabbed_;
    pressPixel_ = event.pixel;
    pressPlace_ = boxPlace_ = event.place;
    adds_ = event.modifiers.shift();
    single_ = false; // a drag moves the whole group; a click is over at the release
    pressedControl_ = event.modifiers.control();
    selectedBefore_ = context.selection;
    if (pressLabel(event, context)) {
        mode_ = Mode::Idle;
        return;
    }
    if (event.clicks == 2 && editDimension(event, context)) {
        mode_ = Mode::Idle;
        return;
    }
    if (event.clicks == 2 && grabbed_.kind == Hit::Kind::Segment) {
        insertAt(grabbed_, context);
        return;
    }
    if (grabbed_.kind == Hit::Kind::Transform) {
        transform_.begin(grabbed_.transform, event, context, joints(context));
        mode_ = Mode::Transforming;
        return;
    }
    if (grabbed_.kind == Hit::Kind::Guide) {
        guide_.begin(context, grabbed_.guide);
        mode_ = Mode::Guiding;
        return;
    }
    wasSelected_ = isSelected(grabbed_, context.selection);
    adds_ = adds_ && grabbed_.kind != Hit::Kind::Control;
    const bool moves = grabbed_.kind == Hit::Kind::Face && wasSelected_ && !adds_ && !event.modifiers.alt();
    if (grabbed_.isFree() && !moves) {
        mode_ = Mode::Boxing;
        lasso_.clear();
        if (event.modifiers.alt()) {
            lasso_.push_back(event.place);
        }
        return;
    }
    if (adds_ || !wasSelected_) {
        select(grabbed_, adds_, context.selection);
    }
    mode_ = Mode::Grabbed;
}

bool SelectTool::editDimension(const CanvasEvent &event, Shell &context) {
    const SketchConstraint *const constraint =
        grabbed_.kind == Hit::Kind::Constraint ? findConstraint(*start_, grabbed_.constraint) : nullptr;
    if (constraint == nullptr || !isDimension(constraint->kind)) {
        return false;
    }
    context.selection.clear();
    context.selection.constraints.insert(grabbed_.constraint);
    context.dimensionEntry.open(*start_, context.document.revision(), grabbed_.constraint, event.pixel);
    context.animate();
    return true;
}

/// Handles a click on the label of a boundary part or region: the first selects what it names, unless something else is
/// right under the pointer, the second renames it.
bool SelectTool::pressLabel(const CanvasEvent &event, Shell &context) {
    std::optional<NamedThing> thing = labelAt(context, event.pixel);
    if (event.clicks == 2 && !thing) {
        thing = pressedLabel_; // the label has made way for what the first click selected
    }
    pressedLabel_ = thing;
    const bool ofFace = grabbed_.kind == Hit::Kind::Face && thing && thing->kind == NamedThing::Kind::Region;
    if (!thing || ((!grabbed_.isFree() || ofFace) && event.clicks < 2) || adds_) {
        return false;
    }
    context.selection = selectionOf(*start_, *thing);
    if (event.clicks == 2) {
        context.naming.openOnCanvas(*thing, event.pixel, context.document, true);
        context.animate();
    }
    return true;
}

void SelectTool::insertAt(const Hit &hit, Shell &context) {
    if (!applyJoined(context, insertNode(*start_, hit.segment->ref, hit.at), "Insert node")) {
        mode_ = Mode::Idle;
        return;
    }
    // The button is still down on the new node, so a drag moves it.
    start_ = context.document.current();
    startIndex_ = state_->index(context);
    grabbed_.kind = Hit::Kind::Node;
    const std::vector<Vec2> &nodes = findShape(*start_, hit.shape)->nodes;
    const auto inserted = std::find(nodes.begin(), nodes.end(), hit.at);
    grabbed_.node = {hit.shape, static_cast<std::uint32_t>(inserted - nodes.begin())};
    select(grabbed_, false, context.selection);
    wasSelected_ = false;
    mode_ = Mode::Grabbed;
}

void SelectTool::selectInside(Vec2 end, Shell &context) {
    const std::shared_ptr<const PickIndex> index = state_->index(context);
    const auto found = [&](bool handles) {
        Selection inside =
            lasso_.empty() ? index->inBox(boxOf(pressPlace_, end), handles) : index->inLoop(lasso_, handles);
        state_->picks.apply(inside);
        return inside;
    };
    Selection inside = found(false);
    if (inside.empty()) {
        inside = found(true); // without a whole shape inside, the nodes there
    }
    if (!adds_) {
        context.selection.clear();
    }
    completeGroups(*context.document.current(), inside);
    context.selection.shapes.merge(inside.shapes);
    context.selection.nodes.merge(inside.nodes);
    context.selection.sources.merge(inside.sources);
    context.selection.markers.merge(inside.markers);
}

void SelectTool::release(const CanvasEvent &event, Shell &context) {
    const double slack = static_cast<double>(context.px(3));
    // A loop may end where it began.
    const bool looped = mode_ == Mode::Boxing && std::any_of(lasso_.begin(), lasso_.end(), [&](Vec2 place) {
                            return glm::distance(context.view.camera.toPixel(place), pressPixel_) > slack;
                        });
    const bool moved = looped || glm::distance(event.pixel, pressPixel_) > slack;
    single_ = pressedControl_ && !moved;
    if (mode_ == Mode::Boxing && moved) {
        selectInside(event.place, context);
    } else if (mode_ == Mode::Guiding) {
        guide_.finish(context, event.pixel);
    } else if (mode_ == Mode::Transforming) {
        transform_.finish(context);
    } else if (mode_ == Mode::Moving) {
        joinMoved(context);
        addRelations(context);
    } else if (mode_ == Mode::Boxing) {
        // A second click selects the face rather than the shape around it.
        const bool closer = !adds_ && event.clicks < 2 && clicked_ == grabbed_.shape &&
                            context.selection.shapes.contains(grabbed_.shape) && context.selection.size() == 1 &&
                            hasFaceWithin(grabbed_);
        select(grabbed_, adds_, context.selection);
        if (closer) {
            selectFaceOf(grabbed_, false, context.selection);
        }
    } else if (mode_ == Mode::Grabbed && single_ && (adds_ || !wasSelected_)) {
        context.selection = selectedBefore_; // the press has selected the group
        select(grabbed_, adds_, context.selection);
    } else if (mode_ == Mode::Grabbed && wasSelected_ && !adds_ && event.clicks < 2) {
        // A second click selects the segment rather than the shape.
        const bool closer = grabbed_.kind == Hit::Kind::Segment && clicked_ == grabbed_.shape &&
                            context.selection.shapes.contains(grabbed_.shape) && context.selection.size() == 1;
        select(grabbed_, false, context.selection);
        if (closer) {
            context.selection.clear();
            context.selection.segments.insert(grabbed_.segment->ref);
        }
    }
    clicked_ = moved ? kNoIndex : grabbed_.shape;
    endDrag();
    hover_ = hitAt(event.place, context);
}

bool SelectTool::key(const CanvasEvent &event, Shell &context) {
    if (mode_ != Mode::Idle) {
        if (event.key == key::kEscape && mode_ == Mode::Guiding) {
            guide_.cancel(context);
            mode_ = Mode::Idle;
        } else if (event.key == key::kEscape) {
            const bool strokes = mode_ == Mode::Moving || mode_ == Mode::Labelling;
            context.document.abandonStroke(strokes ? stroke_ : std::string());
            followFaces(context, {});
            mode_ = Mode::Idle;
        }
        return true; // no command removes what is being dragged
    }
    if (event.modifiers.control() || event.modifiers.alt()) {
        return false;
    }
    switch (event.key) {
    case key::kEscape:
        // Esc first cancels what runs.
        if (!context.selection.empty() && !context.actions.find("run.cancel")->enabled(context)) {
            context.selection.clear();
            return true;
        }
        return false;
    case key::kBackspace:
        return context.actions.run("edit.delete", context);
    case key::kLeft:
        nudge({-1, 0}, event.modifiers.shift(), event.repeated, context);
        return !context.selection.empty();
    case key::kRight:
        nudge({1, 0}, event.modifiers.shift(), event.repeated, context);
        return !context.selection.empty();
    case key::kUp:
        nudge({0, 1}, event.modifiers.shift(), event.repeated, context);
        return !context.selection.empty();
    case key::kDown:
        nudge({0, -1}, event.modifiers.shift(), event.repeated, context);
        return !context.selection.empty();
    default:
        return false;
    }
}

void SelectTool::nudge(Vec2 direction, bool far, bool repeated, Shell &context) {
    if (context.selection.size() == context.selection.constraints.size()) {
        return; // constraints have no place
    }
    if (!repeated || nudgeStroke_.empty()) {
        nudgeStroke_ = state_->newStroke();
    }
    // A tenth of the drawing grid; with Shift a whole step.
    const double step = EditState::gridStep(context) * (far ? 1.0 : 0.1);
    if (const FacesMeant meant = facesMeant(context); meant.map) {
        const std::set<Vec2, PlaceOrder> places = context.selection.faces;
        if (context.applyCommand(moveFaces(*state_->index(context), *meant.map, meant.faces, step * direction), "Nudge",
                                 nudgeStroke_)) {
            context.selection.faces.clear();
            for (const Vec2 place : places) {
                context.selection.faces.insert(place + step * direction);
            }
        }
        return;
    }
    applyJoined(context, moveSelection(*context.document.current(), context.selection, step * direction), "Nudge",
                nudgeStroke_);
}

} // namespace forefront
