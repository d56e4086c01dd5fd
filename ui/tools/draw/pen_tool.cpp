#include "ui/tools/draw/pen_tool.hpp"

#include "core/drawing/commands/drawn_paths.hpp"
#include "core/drawing/commands/inferred_constraints.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "core/engine/geometry/stroke_fit.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/common/tool_options.hpp"
#include "ui/widgets/enum_choice.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/relation_options.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace forefront {
namespace {

/// Announces a failure, without the tick of a successful command.
void warn(Shell &context, std::string message) {
    Diagnostic warning;
    warning.severity = Severity::Warning;
    warning.code = "unfinished-path";
    warning.message = std::move(message);
    context.log.add(std::move(warning));
}

} // namespace

const char *PenTool::icon() const {
    return kind_ == ShapeKind::Polygon ? icon::kPolygon : icon::kPolyline;
}

std::optional<Vec2> PenTool::anchor() const {
    return path_.empty() ? std::nullopt : std::optional(path_.back().at);
}

Curve PenTool::segment(const Node &from, const Node &to) {
    if (to.arc) {
        return *to.arc;
    }
    return curved(from, to) ? Curve::cubic(from.at, from.at + from.arm, to.at - to.arm, to.at)
                            : Curve::line(from.at, to.at);
}

bool PenTool::anyCurved() const {
    return std::any_of(path_.begin(), path_.end(), [](const Node &node) { return node.arc || node.arm != Vec2{}; });
}

std::optional<Vec2> PenTool::ownSnap(Vec2 at, const Shell &context) const {
    const bool near = canClose() && distance(at, path_.front().at) <= EditState::reach(context, 10.0);
    return near ? std::optional(path_.front().at) : std::nullopt;
}

bool PenTool::describePath(InferenceQuery &query) const {
    if (mode_ != PenMode::Corners || drawsArc()) {
        return false;
    }
    for (std::size_t k = 0; k < path_.size(); ++k) {
        query.path.push_back(path_[k].at);
        if (k > 0) {
            query.straight.push_back(!curved(path_[k - 1], path_[k]));
        }
    }
    if (!path_.empty() && path_.back().arm == Vec2{}) { // with an arm, the next segment is a curve
        query.starts = {path_.back().at};
        if (path_.size() > 1 && !query.straight.back()) {
            query.arrival = heading();
        }
    }
    return true;
}

std::vector<InferredNode> PenTool::relationsOf(const Shape &shape) const {
    return mode_ == PenMode::Corners ? relationsOfPath(shape) : std::vector<InferredNode>();
}

std::vector<Curve> PenTool::splineOf(bool closed) const {
    std::vector<Vec2> points;
    for (const Node &node : path_) {
        points.push_back(node.at);
    }
    return splineThrough(points, closed);
}

double PenTool::freehandTolerance(const Shell &context) const {
    return state_->freehandTolerance > 0.0 ? state_->freehandTolerance : EditState::reach(context, 2.0);
}

void PenTool::finishFreehand(Vec2 at, Shell &context) {
    hand_.push_back(at);
    const bool loop =
        kind_ == ShapeKind::Polygon && distance(hand_.back(), hand_.front()) <= EditState::reach(context, 10.0);
    state_->freehandPath == FreehandPath::Smooth ? smoothStroke(context, loop) : simplifyStroke(context, loop);
    cancel();
}

void PenTool::simplifyStroke(Shell &context, bool loop) {
    path_.clear();
    for (const Vec2 node : simplified(hand_, freehandTolerance(context))) {
        path_.push_back({node, {}});
    }
    if (loop && path_.size() > 3) {
        path_.pop_back();
    }
    finish(context);
}

void PenTool::smoothStroke(Shell &context, bool loop) {
    // What lies beside the ends, which have snapped, would bend the path there; the end of a loop meets its beginning.
    const double beside = EditState::reach(context, 6.0), overlap = EditState::reach(context, 10.0);
    const Vec2 first = hand_.front(), last = hand_.back();
    std::vector<Vec2> stroke = hand_;
    stroke.pop_back();
    while (stroke.size() > 2 && distance(stroke.back(), loop ? first : last) <= (loop ? overlap : beside)) {
        stroke.pop_back();
    }
    while (stroke.size() > 2 && distance(stroke[1], first) <= beside) {
        stroke.erase(stroke.begin() + 1);
    }
    if (!loop) {
        stroke.push_back(last);
    }
    Shape shape;
    PathForm &path = shape.path();
    path.closed = kind_ == ShapeKind::Polygon;
    path.curves = fitStroke(stroke, freehandTolerance(context), loop);
    for (Curve &curve : path.curves) {
        shape.nodes.push_back(curve.point(0.0));
        curve = curve.kind() == CurveKind::Line ? Curve() : curve;
    }
    if (!loop) {
        shape.nodes.push_back(last);
        if (kind_ == ShapeKind::Polygon) {
            path.curves.emplace_back(); // straight back to the beginning
        }
    }
    const bool curved = std::any_of(path.curves.begin(), path.curves.end(),
                                    [](const Curve &curve) { return curve.kind() != CurveKind::Line; });
    const std::size_t needed = kind_ == ShapeKind::Polygon && !curved ? 3 : 2;
    if (shape.nodes.size() < needed) {
        announceTooFew(context);
        return;
    }
    if (!curved) {
        path.curves.clear();
    }
    commit(context, std::move(shape));
}

void PenTool::release(Vec2 at, bool away, Shell &context) {
    if (mode_ != PenMode::Freehand) {
        return;
    }
    if (away || hand_.size() >= 3) { // a loop may end where it began
        finishFreehand(at, context);
    } else {
        cancel();
        clicked_ = true; // drawSketch() says what to do
    }
}

void PenTool::place(Vec2 at, Shell &context) {
    clicked_ = false;
    if (mode_ == PenMode::Freehand) {
        cancel();
        path_ = {{at, {}}};
        hand_ = {at};
        return;
    }
    if (wantsMiddle() && !path_.empty()) {
        middle_ = at != path_.back().at ? std::optional(at) : std::nullopt;
        return;
    }
    Node node{at, {}};
    if (drawsArc() && !path_.empty() && at != path_.back().at) {
        node.arc = arcTo(at);
        node.radius = isTangent() ? entry_.expression(EntryField::Radius) : std::string();
        middle_.reset();
        if (node.arc->kind() == CurveKind::Line) {
            node.arc.reset();
        }
    }
    if (closes(at)) {
        path_.front().arc = node.arc;
        path_.front().radius = node.radius;
        commit(context, true);
        if (!path_.empty()) {
            path_.front().arc.reset(); // refused
        }
        return;
    }
    if (path_.empty() || at != path_.back().at) {
        path_.push_back(std::move(node));
        undone_.clear();
        discarded_.clear();
    }
}

void PenTool::pull(Vec2 to) {
    if (mode_ == PenMode::Freehand) {
        if (hand_.empty() || hand_.back() != place_) {
            hand_.push_back(place_);
        }
        return;
    }
    if (mode_ == PenMode::Spline || drawsArc()) {
        return; // the curve follows from its points alone
    }
    path_.back().arm = to - path_.back().at;
}

void PenTool::finish(Shell &context) {
    if (canFinish()) {
        commit(context, kind_ == ShapeKind::Polygon);
    } else if (!path_.empty()) {
        announceTooFew(context);
    }
}

void PenTool::deactivate(Shell &context) {
    if (canFinish()) {
        finish(context);
    }
    discard(context); // what has too few nodes, or was refused
    DrawingTool::deactivate(context);
}

void PenTool::announceTooFew(Shell &context) const {
    warn(context, kind_ == ShapeKind::Polygon ? "A polygon needs at least three nodes, or two and a curve"
                                              : "A polyline needs at least two nodes");
}

Shape PenTool::shapeOf(bool closed) const {
    Shape shape;
    PathForm &path = shape.path();
    path.closed = closed;
    if (mode_ == PenMode::Spline && path_.size() > 2) {
        path.curves = splineOf(closed);
    }
    const std::size_t segments = path.curves.empty() ? path_.size() - (closed ? 0 : 1) : 0;
    for (std::size_t k = 0; k < path_.size(); ++k) {
        shape.nodes.push_back(path_[k].at);
        if (k < segments) {
            const Node &next = path_[(k + 1) % path_.size()];
            path.curves.push_back(curved(path_[k], next) ? segment(path_[k], next) : Curve());
        }
    }
    return shape;
}

void PenTool::commit(Shell &context, bool closed) {
    commit(context, shapeOf(closed));
}

std::optional<Shape> PenTool::unfinished() const {
    if (path_.size() < 2 || !hand_.empty()) {
        return std::nullopt;
    }
    Shape shape = shapeOf(false);
    shape.use = ShapeUse::Constraint; // an open path cannot bound the domain
    return shape;
}

void PenTool::commit(Shell &context, Shape shape) {
    shape.use = kind_ == ShapeKind::Polygon ? ShapeUse::Boundary : ShapeUse::Constraint;
    if (commitShape(context, std::move(shape), kind_ == ShapeKind::Polygon ? "Draw polygon" : "Draw polyline")) {
        cancel();
    }
}

void PenTool::cancel() {
    hand_.clear();
    path_.clear();
    undone_.clear();
    middle_.reset();
    segment_ = PenSegment::Line;
    clicked_ = false;
}

void PenTool::forget(Shell &context) {
    DrawingTool::forget(context);
    mode_ = PenMode::Corners;
}

bool PenTool::removeLast() {
    if (path_.empty()) {
        return false;
    }
    if (middle_) {
        middle_.reset();
        return true;
    }
    if (!hand_.empty()) {
        cancel(); // a freehand path has no nodes to remove yet
        return true;
    }
    undone_.push_back(path_.back());
    path_.pop_back();
    return true;
}

void PenTool::discard(Shell &context) {
    std::vector<Node> path = hand_.empty() ? std::move(path_) : std::vector<Node>();
    cancel();
    if (path.size() >= 2) {
        discarded_ = std::move(path);
        discardedTyped_ = typedNodes_;
        discardedRevision_ = context.document.revision();
        discardedPlaced_ = state_->placed;
        warn(context, "The path is discarded; Ctrl Z brings it back");
    }
}

bool PenTool::undo(Shell &context) {
    if (bringsBack(context)) {
        path_ = std::exchange(discarded_, {});
        typedNodes_ = std::exchange(discardedTyped_, {});
        return true;
    }
    undoneRevision_ = context.document.revision();
    return DrawingTool::undo(context);
}

std::string PenTool::undoLabel(const Shell &context) const {
    return bringsBack(context) ? "discarding the path" : DrawingTool::undoLabel(context);
}

bool PenTool::bringsBack(const Shell &context) const {
    return path_.empty() && !discarded_.empty() && discardedPlaced_ == state_->placed &&
           discardedRevision_ == context.document.revision();
}

std::string PenTool::redoLabel(const Shell &context) const {
    // Once the path is gone and the document has changed, redo concerns the document.
    const bool here = !path_.empty() || undoneRevision_ == context.document.revision();
    return undone_.empty() || !here ? "" : "last point";
}

bool PenTool::redo(Shell &context) {
    if (redoLabel(context).empty()) {
        return false;
    }
    path_.push_back(undone_.back());
    undone_.pop_back();
    return true;
}

void PenTool::drawPath(CanvasPainter &painter, const Shell &context) const {
    const Theme &theme = context.theme;
    painter.polyline(hand_, false, theme.selection, 2.0);
    const bool smooth = mode_ == PenMode::Spline && path_.size() > 2;
    for (const Curve &curve : smooth ? splineOf(false) : std::vector<Curve>()) {
        painter.curve(curve, theme.selection, 2.0);
    }
    for (std::size_t k = 1; k < path_.size() && !smooth; ++k) {
        painter.curve(segment(path_[k - 1], path_[k]), theme.selection, 2.0);
    }
    for (const Node &node : path_) {
        painter.handle(node.at, 3.0, theme.canvas, theme.selection);
    }
    const Node &last = path_.back();
    if (last.arm != Vec2{}) {
        painter.line(last.at - last.arm, last.at + last.arm, fade(theme.selection, 0.6), 1.0);
        painter.dot(last.at - last.arm, 3.0, theme.selection);
        painter.dot(last.at + last.arm, 3.0, theme.selection);
    }
}

void PenTool::drawSketch(CanvasPainter &painter, Shell &context) {
    const Theme &theme = context.theme;
    if (path_.empty()) {
        drawMeasure(painter, context, {});
        if (clicked_ && over_) {
            painter.label(place_, {16.0, -30.0}, "drag to draw freehand; Corners, above, takes clicks", theme.text,
                          fade(theme.popup, 0.95), context.fonts.small);
        }
        return;
    }
    drawPath(painter, context);
    const Node &last = path_.back();
    const bool closing = closes(pointer_.at), pulling = last.arm != Vec2{} && pointer_.at == last.at + last.arm;
    if ((over_ || entry_.locks().any()) && !pulling) {
        const bool arc = drawsArc() && !wantsMiddle();
        painter.curve(arc ? arcTo(pointer_.at) : segment(last, Node{pointer_.at, closing ? path_.front().arm : Vec2{}}),
                      theme.selection, 1.5);
        if (middle_) {
            painter.dot(*middle_, 3.0, theme.selection);
        }
        if (kind_ == ShapeKind::Polygon && path_.size() >= 2 && !closing) {
            painter.dashed(pointer_.at, path_.front().at, fade(theme.selection, 0.5), 1.0);
        }
    }
    if (canClose()) {
        painter.ring(path_.front().at, closing ? 9.0 : 6.5, theme.selection, closing ? 2.0 : 1.0);
    }
    const Vec2 arm = pointer_.at - last.at;
    const std::optional<double> radius = drawsArc() && !wantsMiddle() ? radiusOf(arcTo(pointer_.at)) : std::nullopt;
    const std::string measure = closing  ? std::string("close")
                                : radius ? "r = " + ui::number(*radius)
                                         : ui::number(length(arm)) + "  \xe2\x88\xa0 " +
                                               ui::number(std::atan2(arm.y, arm.x) * 180.0 / std::numbers::pi, 3) +
                                               "\xc2\xb0";
    drawMeasure(painter, context, over_ ? measure : std::string());
}

void PenTool::drawOptions(Shell &context, ui::Flow &flow) {
    flow.item("pen");
    const float width = std::min(220.0F, flow.room() / context.scale);
    if (mode_ == PenMode::Corners && !path_.empty()) { // another way of drawing would drop the path
        if (ui::segmented(context, "options/segment", segment_, width)) {
            middle_.reset();
        }
        ui::tooltip(context,
                    "The next segment, by keys: L for a line, A for an arc that is tangent to the segment before "
                    "it, A again for an arc through a point");
    } else {
        if (ui::segmented(context, "options/pen", mode_, width)) {
            cancel();
        }
        ui::tooltip(context,
                    "Corners: click for corners, drag for curves; A while drawing: arcs. Spline: a smooth curve "
                    "through the points that you click. Freehand: draw by dragging.");
    }
    if (mode_ == PenMode::Freehand) {
        flow.item("freehand");
        ui::segmented(context, "options/freehand", state_->freehandPath, std::min(150.0F, flow.room() / context.scale));
        ui::tooltip(context, "Smooth: your stroke becomes curves, with corners where it turns sharply. Corners: it "
                             "becomes straight segments.");
        drawLengthOption(context, flow, "options/tolerance", "Tolerance", state_->freehandTolerance,
                         "Maximum distance between the path and your stroke; 0: two pixels",
                         context.document.current()->unit);
    }
    if (kind_ == ShapeKind::Polygon) {
        drawTagOption(context, flow, *state_, ShapeUse::Boundary, "Tag of the next boundary");
    } else {
        drawTagOption(context, flow, *state_, ShapeUse::Constraint, "Tag of the next inner line");
    }
    state_->drawSnapOptions(context, flow);
    if (mode_ == PenMode::Corners) {
        drawRelationOptions(context, flow);
    }
}

std::string PenTool::statusText(const Shell &) const {
    if (mode_ == PenMode::Freehand) {
        return kind_ == ShapeKind::Polygon ? "Drag to draw an outline freehand; release to close it"
                                           : "Drag to draw a line freehand";
    }
    if (mode_ == PenMode::Spline && !path_.empty() && !(kind_ == ShapeKind::Polygon && canClose())) {
        return "Click the next point of the curve, or type distance, Tab, angle, Enter. Enter alone: finish. "
               "Position: 4,3. Backspace: remove the last point";
    }
    if (path_.empty() && mode_ == PenMode::Spline) {
        return "Click the points of a smooth curve, or type x, Tab, y, Enter. Enter alone: finish";
    }
    if (path_.empty()) {
        return kind_ == ShapeKind::Polygon
                   ? "Click for corners, drag for curves, or type x, Tab, y, Enter. A polygon inside another becomes a "
                     "hole"
                   : "Click for corners, drag for curves, or type x, Tab, y, Enter. The mesh follows the line";
    }
    if (drawsArc()) {
        return wantsMiddle() ? "Click a point on the arc. A: tangent arc, L: line, Backspace: remove the last node"
               : isTangent()
                   ? "Click where the arc ends, or point there and type the radius, Tab, the angle that it turns, "
                     "Enter. A: arc through a point, L: line"
                   : "Click where the arc ends, or type distance, Tab, angle, Enter. Backspace: remove the point";
    }
    return kind_ == ShapeKind::Polygon && canClose()
               ? "Click the next corner, or type distance, Tab, angle, Enter. Click the first node or press Enter "
                 "alone "
                 "to close. A: arc, Backspace: remove the last node, Esc: cancel"
               : "Click the next corner, drag for a curve, or type distance, Tab, angle, Enter. Enter alone: finish. "
                 "Position: 4,3. A: arc, Backspace: remove the last node";
}

} // namespace forefront
