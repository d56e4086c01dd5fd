#include "ui/tools/pen_tool.hpp"

#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/tool_options.hpp"
#include "ui/widgets/widgets.hpp"

#include <numbers>

namespace forefront {

const char *PenTool::icon() const {
    return kind_ == ShapeKind::Polygon ? icon::kPolygon : icon::kPolyline;
}

std::optional<Vec2> PenTool::anchor() const {
    return path_.empty() ? std::nullopt : std::optional(path_.back());
}

std::optional<Vec2> PenTool::ownSnap(Vec2 at, const Shell &context) const {
    const bool near = path_.size() >= 3 && distance(at, path_.front()) <= EditState::reach(context, 10.0);
    return near ? std::optional(path_.front()) : std::nullopt;
}

void PenTool::place(Vec2 at, Shell &context) {
    if (closes(at)) {
        commit(context, true);
        return;
    }
    if (path_.empty() || at != path_.back()) {
        path_.push_back(at);
        undone_.clear();
    }
}

void PenTool::finish(Shell &context) {
    if (path_.size() >= (kind_ == ShapeKind::Polygon ? 3U : 2U)) {
        commit(context, kind_ == ShapeKind::Polygon);
    } else if (!path_.empty()) {
        context.log.announce(kind_ == ShapeKind::Polygon ? "A polygon needs at least three nodes"
                                                         : "A polyline needs at least two nodes");
    }
}

void PenTool::commit(Shell &context, bool closed) {
    Shape shape;
    shape.kind = closed ? ShapeKind::Polygon : ShapeKind::Polyline;
    shape.use = kind_ == ShapeKind::Polygon ? ShapeUse::Boundary : ShapeUse::Constraint;
    shape.nodes = path_;
    if (commitShape(context, std::move(shape), kind_ == ShapeKind::Polygon ? "Draw polygon" : "Draw polyline")) {
        cancel();
    }
}

void PenTool::cancel() {
    path_.clear();
    undone_.clear();
}

bool PenTool::removeLast() {
    if (path_.empty()) {
        return false;
    }
    undone_.push_back(path_.back());
    path_.pop_back();
    return true;
}

bool PenTool::undo(Shell &) {
    return removeLast();
}

bool PenTool::redo(Shell &) {
    if (undone_.empty()) {
        return false;
    }
    path_.push_back(undone_.back());
    undone_.pop_back();
    return true;
}

void PenTool::drawSketch(CanvasPainter &painter, Shell &context) {
    const Theme &theme = context.theme;
    if (path_.empty()) {
        drawMeasure(painter, context, {});
        return;
    }
    painter.polyline(path_, false, theme.selection, 2.0);
    const bool closing = closes(pointer_.at);
    if (over_ || entry_.locks().any()) {
        painter.line(path_.back(), pointer_.at, theme.selection, 1.5);
        if (kind_ == ShapeKind::Polygon && path_.size() >= 2 && !closing) {
            painter.dashed(pointer_.at, path_.front(), fade(theme.selection, 0.5), 1.0);
        }
    }
    for (const Vec2 node : path_) {
        painter.handle(node, 3.0, theme.canvas, theme.selection);
    }
    if (path_.size() >= 3) {
        painter.ring(path_.front(), closing ? 9.0 : 6.5, theme.selection, closing ? 2.0 : 1.0);
    }
    const Vec2 arm = pointer_.at - path_.back();
    const std::string measure = closing ? std::string("close")
                                        : ui::number(length(arm)) + "  \xe2\x88\xa0 " +
                                              ui::number(std::atan2(arm.y, arm.x) * 180.0 / std::numbers::pi, 3) +
                                              "\xc2\xb0";
    drawMeasure(painter, context, over_ ? measure : std::string());
}

void PenTool::drawOptions(Shell &context, ui::Flow &flow) {
    if (kind_ == ShapeKind::Polygon) {
        drawTagOption(context, flow, state_->boundaryTag, "Tag of the next boundary");
    } else {
        drawTagOption(context, flow, state_->constraintTag, "Tag of the next constraint");
    }
    state_->drawSnapOptions(context, flow);
}

std::string PenTool::statusText(const Shell &) const {
    if (path_.empty()) {
        return kind_ == ShapeKind::Polygon
                   ? "Click the corners, or type x, Tab, y. A polygon inside another becomes a hole"
                   : "Click the nodes of a line for the mesh to follow, or type x, Tab, y";
    }
    return kind_ == ShapeKind::Polygon && path_.size() >= 3
               ? "Click the first node or press Enter to close, Backspace to remove the last node, Esc to cancel"
               : "Click the next node, or type distance, Tab, angle. Enter: finish, Backspace: remove the last node";
}

} // namespace forefront
