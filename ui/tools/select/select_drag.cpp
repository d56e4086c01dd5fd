#include "core/drawing/commands/inferred_constraints.hpp"
#include "core/drawing/commands/join_segments.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/constraints/held_numbers.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/picking/dragged_parts.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/common/source_parts.hpp"
#include "ui/tools/select/select_tool.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace forefront {

void SelectTool::drag(const CanvasEvent &event, Shell &context) {
    over_ = true;
    if (mode_ == Mode::Boxing) {
        boxPlace_ = event.place;
        if (!lasso_.empty()) {
            lasso_.push_back(event.place);
        }
        return;
    }
    if (mode_ == Mode::Guiding) {
        if (glm::distance(event.pixel, pressPixel_) > static_cast<double>(context.px(3))) {
            guide_.update(context, event.pixel, event.modifiers.control());
        }
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
        if (grabbed_.kind == Hit::Kind::Constraint) {
            const SketchConstraint *const constraint = findConstraint(*start_, grabbed_.constraint);
            if (constraint != nullptr && isDimension(constraint->kind)) {
                mode_ = Mode::Labelling;
                stroke_ = state_->newStroke();
                placeLabel(event, context);
            }
            return;
        }
        mode_ = Mode::Moving;
        stroke_ = state_->newStroke();
        entry_.clear();
        beginMove(context);
    }
    if (mode_ == Mode::Labelling) {
        placeLabel(event, context);
    }
    if (mode_ == Mode::Moving) {
        last_ = event;
        updateMove(context);
    }
}

void SelectTool::placeLabel(const CanvasEvent &event, Shell &context) {
    const SketchConstraint *const constraint = findConstraint(*start_, grabbed_.constraint);
    context.applyCommand(placeDimension(*start_, grabbed_.constraint, grabbed_.at + (event.place - pressPlace_)),
                         "Place " + constraint->name, stroke_);
}

/// Takes the selection to move and finds out once what it can snap to, so that every step is cheap.
void SelectTool::beginMove(Shell &context) {
    moving_ = context.selection;
    const bool byNode = grabbed_.kind == Hit::Kind::Node;
    startJoints_ = joints(context);
    startConstraints_.reset();
    aloneConstraints_.reset();
    heldBy_.reset();
    if (grabbed_.kind == Hit::Kind::Control) {
        targets_ = aloneTargets_ = PickIndex::Filter([this](const Shape &shape) { return !moving_.touches(shape.id); });
    } else {
        targets_ = targetsOfDrag(*start_, startJoints_->withJoined(moving_));
        aloneTargets_ = targetsOfDrag(*start_, moving_);
    }
    linesTo_ = byNode ? linesToNode(*start_, moving_, grabbed_.node) : std::vector<Vec2>();
}

namespace {

/// Returns the node of the moved shapes that is nearest to a place; none if no shape moves as a whole.
std::optional<Vec2> nearestMovedNode(const Document &document, const Selection &moving, Vec2 at) {
    std::optional<Vec2> nearest;
    for (const std::uint32_t id : moving.shapes) {
        const Shape *const shape = findShape(document, id);
        for (const Vec2 node : shape != nullptr ? handlesOf(*shape) : std::vector<Vec2>()) {
            if (!nearest || distance(node, at) < distance(*nearest, at)) {
                nearest = node;
            }
        }
    }
    return nearest;
}

/// Snaps the place `from` of a shape that is dragged there, not by a node: without another target, not this place but
/// `node` comes to lie on the grid.
Snapped snapByNode(const PickIndex &index, SnapQuery query, Vec2 from, Vec2 node) {
    SnapQuery ofNode;
    ofNode.at = node + (query.at - from);
    ofNode.gridPitch = std::exchange(query.gridPitch, 0.0);
    ofNode.guides = false;
    ofNode.filter = [](const Shape &) { return false; };
    Snapped snapped = snap(index, query);
    if (snapped.kind == SnapKind::None && !query.off) {
        snapped = {from + (snap(index, ofNode).at - node), SnapKind::Grid};
    }
    return snapped;
}

} // namespace

void SelectTool::updateMove(Shell &context) {
    alone_ = last_.modifiers.alt();
    SnapQuery query = state_->query(context, grabbed_.at + (last_.place - pressPlace_),
                                    last_.modifiers.shift() && !adds_, last_.modifiers.control());
    query.guides = query.guides && showsLayer(context.layers, "guides");
    query.anchor = grabbed_.at;
    query.locks = entry_.locks();
    query.lines = linesTo_;
    if (context.snapping.infers && grabbed_.kind == Hit::Kind::Node && moving_.nodes.size() == 1 &&
        moving_.shapes.empty()) {
        query.infer = InferenceQuery{.starts = linesTo_, .reach = EditState::reach(context, 200.0)};
    }
    if (context.snapping.toDrawing) {
        query.filter = alone_ ? aloneTargets_ : targets_;
    }
    if (grabbed_.kind == Hit::Kind::Control) {
        const Shape *const shape = findShape(*start_, grabbed_.shape);
        const std::size_t end = grabbed_.control.segment + (grabbed_.control.atEnd ? 1U : 0U);
        query.anchor = shape->nodes[end % shape->nodes.size()];
    }
    if (const std::optional<TypedPair> pair = entry_.pair()) {
        snapped_ = lockedAt(pair->relative ? *query.anchor + pair->value : pair->value);
    } else if (const auto node = nearestMovedNode(*start_, moving_, grabbed_.at);
               node && grabbed_.kind != Hit::Kind::Node && query.gridPitch > 0.0 && !query.locks.any()) {
        snapped_ = snapByNode(*startIndex_, std::move(query), grabbed_.at, *node);
    } else {
        snapped_ = snap(*startIndex_, query);
    }
    asked_ = snapped_.at;
    Result<Document> next = moved(asked_);
    fault_.clear();
    if (next && !start_->constraints.empty()) {
        const Document wanted = *std::move(next);
        next = constrained(wanted);
        showWhereHeld(wanted, *next);
    }
    if (next) {
        context.applyCommand(std::move(next), moveLabel(), stroke_);
        return;
    }
    const Diagnostic &fault = next.faults().front();
    fault_ = fault.advice.empty() ? fault.message : fault.message + "; " + fault.advice;
    if (context.document.current() != start_) {
        context.document.abandonStroke(stroke_); // the result depends on where the pointer is, not on its way
    }
}

void SelectTool::showWhereHeld(const Document &wanted, const Document &held) {
    const auto placeIn = [this](const Document &document) {
        const Shape *const shape = findShape(document, grabbed_.node.shape);
        return handlesOf(*shape)[grabbed_.node.node];
    };
    if (grabbed_.kind != Hit::Kind::Node || placeIn(wanted) == placeIn(held)) {
        return;
    }
    constexpr double kNear = 1e-9; // of the drawing
    const double near = kNear * boundsOf(*start_).diagonal();
    if (distance(placeIn(wanted), placeIn(held)) <= near) {
        return;
    }
    snapped_ = {placeIn(held), SnapKind::None};
    if (distance(placeIn(held), placeIn(*start_)) > near) {
        return; // it goes as far as it can, which tells enough
    }
    if (!heldBy_) { // found once: the drag stays smooth
        const std::optional<HeldNumbers> numbers = heldNumbers(*start_, wanted, held);
        heldBy_ = numbers && !numbers->names.empty() ? numbers->names : "its sketch constraints";
    }
    fault_ = "held by " + *heldBy_;
}

void SelectTool::addRelations(Shell &context) {
    if (!context.snapping.addsConstraints || snapped_.inferred.empty() || grabbed_.kind != Hit::Kind::Node ||
        context.document.current() == start_) {
        return;
    }
    const InferredNode node{snapped_.at, snapped_.inferred, {}};
    InferredConstraints constrained =
        addInferred(*context.document.current(), grabbed_.shape, std::span(&node, 1), *start_);
    if (constrained.added > 0 && context.applyCommand(std::move(constrained.document), moveLabel(), stroke_)) {
        context.log.announce("Added " + countText(constrained.added, "sketch constraint"));
    }
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
    if (context.applyCommand(std::move(joined), moveLabel(), stroke_)) {
        context.selection.nodes = std::move(nodes);
    }
}

void SelectTool::tellWhereHeld(Shell &context) const {
    const Result<Document> wanted = moved(asked_);
    if (!wanted || start_->constraints.empty()) {
        return;
    }
    if (const std::optional<HeldNumbers> held = heldNumbers(*start_, *wanted, *context.document.current())) {
        context.log.refuse(held->numbers + " cannot hold together with " +
                           (held->names.empty() ? "the sketch constraints" : held->names) +
                           "; what was moved is as near as they allow");
    }
}

bool SelectTool::typedMove(const CanvasEvent &event, Shell &context) {
    if (mode_ != Mode::Moving) {
        return false;
    }
    static constexpr std::array kDirection{EntryField::Distance, EntryField::Angle};
    const NumericEntry::Answer answer = entry_.handle(event, kDirection, start_->spacing.names, {}, start_->unit);
    if (answer == NumericEntry::Answer::Unused) {
        return false;
    }
    updateMove(context);
    if (answer == NumericEntry::Answer::Place) {
        tellWhereHeld(context);
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
    case Hit::Kind::Source: {
        const SizeSource &source = start_->spacing.sources[grabbed_.source.source];
        const bool resizes = grabbed_.source.part == SourcePart::Rim || cornerOfPart(source, grabbed_.source.part);
        return resizes ? "Resize source" : "Move source";
    }
    case Hit::Kind::Marker:
        return "Move region marker";
    default:
        return moving_.shapes.empty() ? "Move segment" : moving_.shapes.size() > 1 ? "Move shapes" : "Move shape";
    }
}

Result<Document> SelectTool::moved(Vec2 to) const {
    if (grabbed_.kind == Hit::Kind::Source && moving_.size() == 1 && grabbed_.source.part != SourcePart::Whole) {
        const SizeSource &source = start_->spacing.sources[grabbed_.source.source];
        return replaceSource(*start_, grabbed_.source.source, withMovedPart(source, grabbed_.source.part, to));
    }
    const Result<Document> next = grabbed_.kind == Hit::Kind::Control
                                      ? moveControl(*start_, grabbed_.control, to, alone_)
                                      : moveSelection(*start_, moving_, to - grabbed_.at);
    return next && !alone_ ? startJoints_->carry(*next) : next;
}

const std::shared_ptr<const Joints> &SelectTool::joints(const Shell &context) const {
    std::shared_ptr<const Document> document = context.document.current();
    if (!joints_ || joints_->document() != document) {
        joints_ = std::make_shared<const Joints>(std::move(document));
    }
    return joints_;
}

Document SelectTool::constrained(const Document &moved) {
    const bool leaves = alone_ && grabbed_.kind != Hit::Kind::Control;
    std::optional<ConstraintDrag> &drag = leaves ? aloneConstraints_ : startConstraints_;
    if (!drag) {
        const bool control = grabbed_.kind == Hit::Kind::Control;
        const std::set<NodeRef> nodes = control ? std::set<NodeRef>() : nodesMovedWith(*start_, moving_);
        drag.emplace(start_, leaves ? nodes : std::set<NodeRef>(), nodes);
    }
    return drag->carry(moved);
}

} // namespace forefront
