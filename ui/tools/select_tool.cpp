#include "ui/tools/select_tool.hpp"

#include "core/edit/join_segments.hpp"
#include "core/edit/shape_commands.hpp"
#include "core/edit/shape_geometry.hpp"
#include "core/edit/spacing_commands.hpp"
#include "ui/parts/shell.hpp"

#include <algorithm>
#include <array>
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
    const bool grabs = over_ && hover_.kind != Hit::Kind::Nothing && hover_.kind != Hit::Kind::Inside;
    return grabs && mode_ != Mode::Boxing ? CursorShape::Hand : CursorShape::Arrow;
}

void SelectTool::deactivate(Shell &) {
    mode_ = Mode::Idle;
    over_ = false;
    transform_.end();
    start_.reset();
    startIndex_.reset();
}

std::optional<Control> SelectTool::controlAt(Vec2 place, Shell &context) const {
    std::optional<Control> best;
    double limit = EditState::reach(context, 8.0);
    const double apart = EditState::reach(context, 4.0); // nearer to its node, a click means the node
    for (const Control &control : controlsOf(*context.document.current(), context.selection)) {
        const double d = distance(control.at, place);
        if (d <= limit && distance(control.at, control.node) > apart && d <= distance(control.node, place)) {
            best = control;
            limit = d;
        }
    }
    return best;
}

std::optional<NodeHit> SelectTool::nodeAt(Vec2 place, const PickIndex::Filter &pickable, Shell &context) const {
    const PickIndex &index = *state_->index(context);
    const auto isShown = [&](const Shape &shape) {
        return pickable(shape) && (shape.kind == ShapeKind::Point || context.selection.touches(shape.id));
    };
    const auto shown = index.node(place, EditState::reach(context, 8.0), isShown);
    return shown ? shown : index.node(place, EditState::reach(context, 4.0), pickable);
}

SelectTool::Hit SelectTool::hitAt(Vec2 place, Shell &context) const {
    const PickIndex &index = *state_->index(context);
    const SelectionFilter &picks = state_->picks;
    const auto isFree = [&picks](const Shape &shape) { return !shape.locked && picks.shapes; };
    const auto hasNodes = [&](const Shape &shape) { return isFree(shape) && picks.nodes; };
    Hit hit;
    hit.at = place;
    if (const auto control = controlAt(place, context)) {
        hit.kind = Hit::Kind::Control;
        hit.control = control->ref;
        hit.shape = control->ref.shape;
        hit.at = control->at;
    } else if (const auto node = nodeAt(place, hasNodes, context)) {
        hit.kind = Hit::Kind::Node;
        hit.node = node->ref;
        hit.shape = node->ref.shape;
        hit.at = node->at;
    } else if (const auto source = index.source(place, EditState::reach(context, 8.0)); source && picks.sources) {
        hit.kind = Hit::Kind::Source;
        hit.source = *source;
        const SizeSource &what = index.document().spacing.sources[source->source];
        using Part = PickIndex::SourceHit::Part;
        hit.at = source->part == Part::A ? what.a : source->part == Part::B ? what.b : place;
    } else if (const auto marker = index.marker(place, EditState::reach(context, 9.0)); marker && picks.markers) {
        hit.kind = Hit::Kind::Marker;
        hit.marker = *marker;
        hit.at = index.document().regionMarkers[*marker].at;
    } else if (const auto handle = transform_.at(place, context)) {
        hit.kind = Hit::Kind::Transform;
        hit.transform = *handle;
    } else if (const auto segment = index.segment(place, EditState::reach(context, 6.0), isFree)) {
        hit.kind = Hit::Kind::Segment;
        hit.segment = segment;
        hit.shape = segment->ref.shape;
        hit.at = segment->at;
    } else if (const std::uint32_t shape = index.shape(place, 0.0); shape != kNoIndex && picks.shapes) {
        hit.kind = Hit::Kind::Inside;
        hit.shape = shape;
    }
    return hit;
}

bool SelectTool::isSelected(const Hit &hit, const Selection &selection) const {
    switch (hit.kind) {
    case Hit::Kind::Control:
    case Hit::Kind::Transform:
        return true; // only those of the selection are shown
    case Hit::Kind::Node:
        return selection.nodes.contains(hit.node);
    case Hit::Kind::Source:
        return selection.sources.contains(hit.source.source);
    case Hit::Kind::Marker:
        return selection.markers.contains(hit.marker);
    case Hit::Kind::Segment:
        return selection.shapes.contains(hit.shape) || selection.segments.contains(hit.segment->ref);
    case Hit::Kind::Inside:
        return selection.shapes.contains(hit.shape);
    case Hit::Kind::Nothing:
        break;
    }
    return false;
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

void SelectTool::select(const Hit &hit, bool adds, Selection &selection) const {
    if (hit.kind == Hit::Kind::Control || hit.kind == Hit::Kind::Transform) {
        return;
    }
    // Beside a selected segment, another segment of the shape is meant.
    const bool segment = hit.kind == Hit::Kind::Segment && !selection.segments.empty() && selection.shapes.empty() &&
                         std::all_of(selection.segments.begin(), selection.segments.end(),
                                     [&](const SegmentRef &chosen) { return adds || chosen.shape == hit.shape; });
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
        if (beside || (shape != nullptr && shape->kind == ShapeKind::Point)) {
            choose(selection.shapes, hit.shape, adds);
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
    case Hit::Kind::Segment:
        if (segment) {
            choose(selection.segments, hit.segment->ref, adds);
        } else {
            choose(selection.shapes, hit.shape, adds);
        }
        break;
    case Hit::Kind::Inside:
        choose(selection.shapes, hit.shape, adds);
        break;
    case Hit::Kind::Control:
    case Hit::Kind::Transform:
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
        return true;
    case Kind::Leave:
        over_ = false;
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
    grabbed_ = hover_ = hitAt(event.place, context);
    pressPixel_ = event.pixel;
    pressPlace_ = boxPlace_ = event.place;
    adds_ = event.modifiers.shift();
    if (event.clicks == 2 && grabbed_.kind == Hit::Kind::Segment) {
        insertAt(grabbed_, context);
        return;
    }
    if (grabbed_.kind == Hit::Kind::Transform) {
        transform_.begin(grabbed_.transform, event, context);
        mode_ = Mode::Transforming;
        return;
    }
    wasSelected_ = isSelected(grabbed_, context.selection);
    adds_ = adds_ && grabbed_.kind != Hit::Kind::Control;
    if (grabbed_.kind == Hit::Kind::Nothing || grabbed_.kind == Hit::Kind::Inside) {
        mode_ = Mode::Boxing;
        return;
    }
    if (adds_ || !wasSelected_) {
        select(grabbed_, adds_, context.selection);
    }
    mode_ = Mode::Grabbed;
}

/// Selects the item under the pointer, unless it already is selected, and requests the menu of the selection.
void SelectTool::openMenu(const CanvasEvent &event, Shell &context) {
    start_ = context.document.current();
    const Hit hit = hitAt(event.place, context);
    if (!isSelected(hit, context.selection)) {
        select(hit, false, context.selection);
    }
    start_.reset();
    context.contextMenu = true;
}

void SelectTool::insertAt(const Hit &hit, Shell &context) {
    if (!EditState::apply(context, insertNode(*start_, hit.segment->ref, hit.at), "Insert node")) {
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

void SelectTool::drag(const CanvasEvent &event, Shell &context) {
    over_ = true;
    if (mode_ == Mode::Boxing) {
        boxPlace_ = event.place;
        return;
    }
    if (mode_ == Mode::Transforming) {
        transform_.drag(event, context);
        return;
    }
    if (mode_ == Mode::Grabbed && glm::distance(event.pixel, pressPixel_) > static_cast<double>(context.px(3))) {
        const bool asShape = grabbed_.kind == Hit::Kind::Node && context.selection.nodes.empty() &&
                             context.selection.shapes.contains(grabbed_.shape);
        if (!asShape && !isSelected(grabbed_, context.selection)) {
            return; // Shift removed it from the selection
        }
        mode_ = Mode::Moving;
        stroke_ = state_->newStroke();
        entry_.clear();
        moving_ = context.selection;
    }
    if (mode_ == Mode::Moving) {
        last_ = event;
        updateMove(context);
    }
}

void SelectTool::updateMove(Shell &context) {
    SnapQuery query = state_->query(context, grabbed_.at + (last_.place - pressPlace_),
                                    last_.modifiers.shift() && !adds_, last_.modifiers.control());
    query.anchor = grabbed_.at;
    query.locks = entry_.locks();
    // Do not snap to what is being moved.
    if (context.snapping.toDrawing) {
        query.filter = [this](const Shape &shape) { return !moving_.touches(shape.id); };
    }
    if (grabbed_.kind == Hit::Kind::Control) {
        const Shape *const shape = findShape(*start_, grabbed_.shape);
        const std::size_t end = grabbed_.control.segment + (grabbed_.control.atEnd ? 1U : 0U);
        query.anchor = shape->nodes[end % shape->nodes.size()];
    }
    alone_ = last_.modifiers.alt();
    if (const std::optional<TypedPair> pair = entry_.pair()) {
        snapped_ = {pair->relative ? *query.anchor + pair->value : pair->value, SnapKind::Locked, {}};
    } else {
        snapped_ = snap(*startIndex_, query);
    }
    EditState::apply(context, moved(snapped_.at), moveLabel(), stroke_);
}

void SelectTool::joinMoved(Shell &context) {
    const std::shared_ptr<const Document> before = context.document.current();
    if (grabbed_.kind != Hit::Kind::Node || before == start_) {
        return;
    }
    std::set<std::uint32_t> moved{grabbed_.shape};
    for (const NodeRef node : moving_.nodes) {
        moved.insert(node.shape);
    }
    Document joined = *before;
    for (const std::uint32_t shape : moved) {
        joined = joinToSegments(joined, shape);
    }
    if (joined.shapes == before->shapes) {
        return;
    }
    // A node inserted into the path itself renumbers those behind it.
    std::set<NodeRef> nodes;
    for (const NodeRef node : context.selection.nodes) {
        const std::vector<Vec2> old = handlesOf(*findShape(*before, node.shape));
        const std::vector<Vec2> now = handlesOf(*findShape(joined, node.shape));
        const auto at = node.node < old.size() ? std::find(now.begin(), now.end(), old[node.node]) : now.end();
        if (at != now.end()) {
            nodes.insert({node.shape, static_cast<std::uint32_t>(at - now.begin())});
        }
    }
    if (EditState::apply(context, std::move(joined), moveLabel(), stroke_)) {
        context.selection.nodes = std::move(nodes);
    }
}

bool SelectTool::typedMove(const CanvasEvent &event, Shell &context) {
    if (mode_ != Mode::Moving) {
        return false;
    }
    static constexpr std::array kDirection{EntryField::Distance, EntryField::Angle};
    const NumericEntry::Answer answer = entry_.handle(event, kDirection, start_->spacing.names);
    if (answer == NumericEntry::Answer::Unused) {
        return false;
    }
    updateMove(context);
    if (answer == NumericEntry::Answer::Place) {
        joinMoved(context);
        entry_.clear();
        mode_ = Mode::Idle; // the button is still down, but the move is over
        context.view.reveal(boxOf(snapped_.at, snapped_.at));
    }
    return true;
}

std::string SelectTool::moveLabel() const {
    switch (grabbed_.kind) {
    case Hit::Kind::Control:
        return "Move control point";
    case Hit::Kind::Node:
        return moving_.size() > 1 ? "Move nodes" : "Move node";
    case Hit::Kind::Source:
        return grabbed_.source.part == PickIndex::SourceHit::Part::Rim ? "Resize source" : "Move source";
    case Hit::Kind::Marker:
        return "Move region marker";
    default:
        return moving_.shapes.empty() ? "Move segment" : moving_.shapes.size() > 1 ? "Move shapes" : "Move shape";
    }
}

Result<Document> SelectTool::moved(Vec2 to) const {
    using Part = PickIndex::SourceHit::Part;
    if (grabbed_.kind == Hit::Kind::Source && moving_.size() == 1 && grabbed_.source.part != Part::Whole) {
        SizeSource source = start_->spacing.sources[grabbed_.source.source];
        const Part part = grabbed_.source.part;
        if (part == Part::Rim) {
            source.radius = distance(source.a, to);
        } else if (source.shape == SourceShape::Line) {
            (part == Part::A ? source.a : source.b) = to;
        } else {
            source.a = to;
        }
        return replaceSource(*start_, grabbed_.source.source, source);
    }
    if (grabbed_.kind == Hit::Kind::Control) {
        return moveControl(*start_, grabbed_.control, to, alone_);
    }
    return moveSelection(*start_, moving_, to - grabbed_.at);
}

void SelectTool::release(const CanvasEvent &event, Shell &context) {
    const bool moved = glm::distance(event.pixel, pressPixel_) > static_cast<double>(context.px(3));
    if (mode_ == Mode::Boxing && moved) {
        const Box2 box = boxOf(pressPlace_, event.place);
        // A box without a whole shape inside selects the nodes inside it.
        Selection inside = state_->index(context)->inBox(box, false);
        state_->picks.apply(inside);
        if (inside.empty()) {
            inside = state_->index(context)->inBox(box, true);
        }
        if (!adds_) {
            context.selection.clear();
        }
        state_->picks.apply(inside);
        context.selection.shapes.merge(inside.shapes);
        context.selection.nodes.merge(inside.nodes);
        context.selection.sources.merge(inside.sources);
        context.selection.markers.merge(inside.markers);
    } else if (mode_ == Mode::Moving) {
        joinMoved(context);
    } else if (mode_ == Mode::Boxing) {
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
    transform_.end();
    clicked_ = moved ? kNoIndex : grabbed_.shape;
    mode_ = Mode::Idle;
    start_.reset();
    startIndex_.reset();
    hover_ = hitAt(event.place, context);
}

bool SelectTool::key(const CanvasEvent &event, Shell &context) {
    if (event.modifiers.control() || event.modifiers.alt()) {
        return false;
    }
    switch (event.key) {
    case key::kEscape:
        if (mode_ == Mode::Moving) {
            context.document.abandonStroke(stroke_);
            mode_ = Mode::Idle;
            return true;
        }
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
    if (context.selection.empty()) {
        return;
    }
    if (!repeated || nudgeStroke_.empty()) {
        nudgeStroke_ = state_->newStroke();
    }
    // A tenth of the drawing grid; with Shift a whole step.
    const double step = gridPitch(EditState::reach(context, 1.0)) * (far ? 1.0 : 0.1);
    EditState::apply(context, moveSelection(*context.document.current(), context.selection, step * direction), "Nudge",
                     nudgeStroke_);
}

} // namespace forefront
