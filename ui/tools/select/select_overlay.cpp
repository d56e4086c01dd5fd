#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/picking/selected_faces.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/domain/element_places.hpp"
#include "core/engine/spacing/spec/source_box.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/select/select_tool.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/relation_options.hpp"
#include "ui/workspace/snap_mark.hpp"

#include <imgui.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <string_view>

namespace forefront {
namespace {

/// Maximum number of handles; more are clutter, and slow to draw.
constexpr std::size_t kMaxHandles = 4000;

void drawBoxHandles(CanvasPainter &painter, const Theme &theme, const SourceBox &box) {
    painter.polyline(box.corners(), true, theme.selection, 2.0);
    for (const Vec2 corner : box.corners()) {
        painter.handle(corner, 3.5, theme.canvas, theme.selection);
    }
    painter.ring(box.centre(), 8.0, theme.selection, 2.0);
}

/// Draws where elements with a bias begin and end along the selected segments of a shape.
void drawBiasMarks(CanvasPainter &painter, const Theme &theme, const Shape &shape, const Outline &outline,
                   const Selection &selection) {
    constexpr std::uint32_t kMaxMarks = 400;
    const bool whole = selection.shapes.contains(shape.id);
    for (std::uint32_t k = 0; k < outline.segmentCount() && !shape.segmentSizes.empty(); ++k) {
        const std::uint32_t part = outline.part(k);
        const auto found = shape.segmentSizes.find(part);
        const bool shown = whole || selection.segments.contains({shape.id, part});
        if (!shown || found == shape.segmentSizes.end() || !found->second.bias.any() ||
            found->second.elements > kMaxMarks) {
            continue;
        }
        const Curve curve = outline.curve(k);
        for (const double place : elementPlaces(found->second.elements, found->second.bias)) {
            const double t = parameterAtLength(curve, place);
            const Vec2 at = curve.point(t), along = curve.tangent(t);
            const Vec2 across = painter.camera().length(5.0 * painter.scale()) * Vec2{-along.y, along.x};
            painter.line(at - across, at + across, theme.canvas, 4.0);
            painter.line(at - across, at + across, theme.selection, 2.0);
        }
    }
}

} // namespace

void SelectTool::drawHandles(CanvasPainter &painter, Shell &context) const {
    const Theme &theme = context.theme;
    const Document &document = *context.document.current();
    const Selection &selection = context.selection;
    const Box2 visible = context.view.camera.visible();
    std::set<std::uint32_t> shown = selection.shapes;
    for (const NodeRef node : selection.nodes) {
        shown.insert(node.shape);
    }
    for (const SegmentRef segment : selection.segments) {
        shown.insert(segment.shape);
    }
    const std::set<std::uint32_t> selected = shown;
    if (over_ && hover_.shape != kNoIndex && hover_.kind != Hit::Kind::Inside) {
        shown.insert(hover_.shape);
    }
    std::size_t drawn = 0;
    for (const auto &shape : document.shapes) {
        if (!shown.contains(shape->id)) {
            continue;
        }
        const bool whole = selection.shapes.contains(shape->id);
        const bool some = selected.contains(shape->id);
        const Outline outline = outlineOf(*shape);
        painter.outline(outline, fade(theme.selection, whole ? 1.0 : 0.5), some ? 2.0 : 1.0);
        const std::vector<Vec2> handles = handlesOf(*shape);
        const auto under = [&](std::uint32_t k) { // would be taken by a click
            return over_ && hover_.kind == Hit::Kind::Node && hover_.node == NodeRef{shape->id, k};
        };
        const std::vector<bool> &joined = jointMarks(shape->id, context);
        for (std::uint32_t k = 0; k < handles.size() && drawn < kMaxHandles; ++k) {
            if ((some || under(k)) && visible.contains(handles[k])) {
                const bool chosen = whole ? shape->is<PointForm>() : selection.nodes.contains({shape->id, k});
                painter.handle(handles[k], chosen ? 4.5 : 3.5, chosen ? theme.selection : theme.canvas,
                               theme.selection);
                if (k < joined.size() && joined[k]) {
                    painter.ring(handles[k], 7.5, theme.selection, 1.0);
                }
                ++drawn;
            }
        }
        for (std::uint32_t k = 0; k < outline.segmentCount(); ++k) {
            if (selection.segments.contains({shape->id, outline.part(k)})) {
                painter.curve(outline.curve(k), theme.selection, 4.0);
            }
        }
        drawBiasMarks(painter, theme, *shape, outline, selection);
    }
}

const std::vector<bool> &SelectTool::jointMarks(std::uint32_t shape, Shell &context) const {
    static const std::vector<bool> kNone;
    if (mode_ == Mode::Transforming || (mode_ == Mode::Moving && alone_)) {
        return kNone; // the first would search the drawing in every frame, the second is being detached
    }
    const std::shared_ptr<const Joints> &now = mode_ == Mode::Moving ? startJoints_ : joints(context);
    if (marked_ != now) {
        marked_ = now;
        marks_.clear();
    }
    const auto found = marks_.find(shape);
    return found != marks_.end() ? found->second : marks_.emplace(shape, now->joinedHandles(shape)).first->second;
}

void SelectTool::drawControls(CanvasPainter &painter, Shell &context) const {
    const Theme &theme = context.theme;
    for (const Control &control : controlsOf(*context.document.current(), context.selection)) {
        const bool under = over_ && hover_.kind == Hit::Kind::Control && hover_.control == control.ref;
        painter.line(control.node, control.at, fade(theme.selection, 0.7), 1.0);
        painter.dot(control.at, under ? 5.0 : 4.0, theme.selection);
        painter.dot(control.at, under ? 3.0 : 2.5, under ? theme.selection : theme.canvas);
    }
}

void SelectTool::drawSourceHandles(CanvasPainter &painter, Shell &context) const {
    const Theme &theme = context.theme;
    const Document &document = *context.document.current();
    for (std::uint32_t k = 0; k < document.spacing.sources.size(); ++k) {
        const SizeSource &source = document.spacing.sources[k];
        const bool chosen = context.selection.sources.contains(k);
        const bool under = over_ && hover_.kind == Hit::Kind::Source && hover_.source.source == k;
        if (!chosen && !under) {
            continue;
        }
        if (source.shape == SourceShape::Box) {
            drawBoxHandles(painter, theme, SourceBox(source));
            continue;
        }
        painter.ring(source.a, 8.0, theme.selection, 2.0);
        if (source.shape == SourceShape::Line) {
            painter.line(source.a, source.b, theme.selection, 2.5);
            painter.ring(source.b, 8.0, theme.selection, 2.0);
        }
        if (source.radius > 0.0) {
            painter.circle(source.a, source.radius, theme.selection, 2.5);
        }
    }
    for (const std::uint32_t k : context.selection.markers) {
        if (k < document.regionMarkers.size()) {
            painter.ring(document.regionMarkers[k].at, 10.0, theme.selection, 2.0);
        }
    }
    if (over_ && hover_.kind == Hit::Kind::Marker && hover_.marker < document.regionMarkers.size()) {
        painter.ring(document.regionMarkers[hover_.marker].at, 10.0, fade(theme.selection, 0.6), 1.5);
    }
}

void SelectTool::reserveOverlay(CanvasPainter &painter, const Shell &context) {
    constexpr std::size_t kMaxReserved = 300; // more would slow down the search for free places
    const Document &document = *context.document.current();
    const Box2 visible = context.view.camera.visible();
    std::size_t reserved = 0;
    const auto reserve = [&](Vec2 place) {
        if (reserved < kMaxReserved && visible.contains(place)) {
            painter.reserve(place, 5.5);
            ++reserved;
        }
    };
    for (const auto &shape : document.shapes) {
        if (!context.selection.touches(shape->id) || !boundsOf(*shape).overlaps(visible)) {
            continue;
        }
        painter.reserve(outlineOf(*shape));
        if (context.selection.shapes.contains(shape->id) && reserved < kMaxReserved) {
            const std::vector<Vec2> handles = handlesOf(*shape);
            std::for_each(handles.begin(), handles.end(), reserve);
        }
    }
    for (const Control &control : controlsOf(document, context.selection)) {
        reserve(control.at);
    }
    for (const Vec2 place : transform_.places(context)) {
        reserve(place);
    }
}

void SelectTool::drawOverlay(CanvasPainter &painter, Shell &context) {
    drawHandles(painter, context);
    drawControls(painter, context);
    drawSourceHandles(painter, context);
    if (mode_ == Mode::Idle || mode_ == Mode::Transforming) {
        const bool under = over_ && hover_.kind == Hit::Kind::Transform;
        transform_.draw(painter, context, under ? std::optional(hover_.transform) : std::nullopt);
    }
    const Theme &theme = context.theme;
    if (mode_ == Mode::Boxing) {
        if (lasso_.empty()) {
            const Box2 box = boxOf(pressPlace_, boxPlace_);
            painter.fillRectangle(box, fade(theme.selection, 0.12));
            painter.rectangle(box, theme.selection, 1.0);
        }
        for (std::size_t k = 1; k < lasso_.size(); ++k) {
            painter.line(lasso_[k - 1], lasso_[k], theme.selection, 1.0);
        }
        if (lasso_.size() > 2) {
            painter.dashed(lasso_.back(), lasso_.front(), theme.selection, 1.0);
        }
    }
    if (mode_ == Mode::Moving) {
        drawSnapMark(painter, context, snapped_);
        const Vec2 way = snapped_.at - grabbed_.at;
        painter.label(snapped_.at, {16.0, 14.0},
                      ui::number(snapped_.at.x, 5) + ", " + ui::number(snapped_.at.y, 5) + "   \xce\x94 " +
                          ui::number(length(way), 3),
                      theme.text, fade(theme.popup, 0.9), context.fonts.small);
        const bool wrong = entry_.isWrong() || !fault_.empty();
        const std::string typed = entry_.isWrong() ? entry_.fault() : fault_.empty() ? entry_.label() : fault_;
        if (!typed.empty()) {
            painter.label(snapped_.at, {16.0, 36.0}, typed, wrong ? theme.bad : theme.accent, theme.popup,
                          context.fonts.strong);
        }
        drawUsedOnce(painter, context, entry_, snapped_.at, 60.0);
    }
}

void SelectTool::drawOptions(Shell &context, ui::Flow &flow) {
    const Selection &selection = context.selection;
    flow.item("selected");
    ImGui::AlignTextToFramePadding();
    const std::size_t count = selection.size();
    constexpr const char *kNothing = "Nothing selected";
    const float room = ImGui::CalcTextSize(kNothing).x; // the widest usual text, so that the buttons stay in place
    ui::muted(context, count == 0 ? kNothing : std::to_string(count) + " selected");
    ImGui::SameLine(0, std::max(0.0F, room - ImGui::GetItemRectSize().x) + context.px(16));
    if (ui::button(context, "options/delete", "Delete", ui::ButtonKind::Plain, count > 0)) {
        context.actions.run("edit.delete", context);
    }
    flow.item("picks");
    if (ui::button(context, "options/picks", "Pick\xe2\x80\xa6")) {
        ImGui::OpenPopup("##picks");
    }
    ui::tooltip(context, "Choose which kinds of items can be selected");
    drawFilter(context);
    state_->drawSnapOptions(context, flow);
    drawRelationOptions(context, flow);
}

/// Draws the popup that chooses which kinds of items can be selected.
void SelectTool::drawFilter(Shell &context) {
    if (!ImGui::BeginPopup("##picks")) {
        return;
    }
    ui::markWindow(context, "picks");
    SelectionFilter &picks = state_->picks;
    bool changed = ui::checkbox(context, "picks/shapes", "Shapes and segments", picks.shapes);
    changed = ui::checkbox(context, "picks/nodes", "Nodes", picks.nodes) || changed;
    changed = ui::checkbox(context, "picks/sources", "Sources", picks.sources) || changed;
    changed = ui::checkbox(context, "picks/markers", "Regions", picks.markers) || changed;
    changed = ui::checkbox(context, "picks/constraints", "Sketch constraints", picks.constraints) || changed;
    if (changed) {
        picks.apply(context.selection);
    }
    ImGui::EndPopup();
}

std::string SelectTool::statusText(const Shell &context) const {
    switch (mode_) {
    case Mode::Moving:
        return "Drag, or type distance, Tab, angle, or a place such as 4,3. Shift: angle steps, Ctrl: no "
               "snapping, Alt: detach from neighbours, Esc: cancel";
    case Mode::Transforming:
        return TransformHandles::statusText(grabbed_.transform);
    case Mode::Boxing:
        return lasso_.empty() ? "Selects the shapes inside the box, or the nodes if no whole shape is inside"
                              : "Selects the shapes inside the lasso, or the nodes if no whole shape is inside";
    case Mode::Labelling:
        return "Drag the value to where it is to lie. Esc: cancel";
    case Mode::Guiding:
        return "Drag the guide, or back to its ruler to remove it. Ctrl: no snapping, Esc: cancel";
    case Mode::Grabbed:
    case Mode::Idle:
        break;
    }
    if (over_ && hover_.kind == Hit::Kind::Guide) {
        return "Drag the guide, or back to its ruler to remove it";
    }
    if (over_ && hover_.kind == Hit::Kind::Constraint) {
        const SketchConstraint *const constraint = findConstraint(*context.document.current(), hover_.constraint);
        const std::string name = constraint != nullptr ? constraint->name + ": " : "";
        return constraint != nullptr && isDimension(constraint->kind)
                   ? name + "double-click to change the value, drag to place it, click and Delete to remove it"
                   : name + "click to select it, Delete to remove it";
    }
    if (over_ && hover_.kind == Hit::Kind::Control) {
        return "Drag the control point. Alt: without the opposite one and neighbours, Shift: angle steps";
    }
    if (over_ && hover_.kind == Hit::Kind::Transform) {
        return TransformHandles::statusText(hover_.transform);
    }
    if (over_ && hover_.kind == Hit::Kind::Segment) {
        return context.selection.shapes.contains(hover_.shape)
                   ? "Click to select this segment, double-click to insert a node"
                   : "Click to select the shape, drag to move it, double-click to insert a node";
    }
    if (over_ && hover_.kind == Hit::Kind::Node) {
        return "Drag to move the node and those joined with it; on the side of another shape it slides along. "
               "Alt-drag to detach it, Delete to remove it";
    }
    if (over_ && hover_.kind == Hit::Kind::Face) {
        const Document &document = *context.document.current();
        const bool selected = isFaceSelected(*hover_.faces, document, context.selection, hover_.face);
        const std::string what =
            hover_.hasRegion()
                ? "region '" + regionName(document.regionNames, hover_.faces->faces()[hover_.face].tag) + '\''
                : "this face";
        return selected ? "Drag to move " + what + " with its border, F2 to name it. Shift-click: remove from selection"
                        : "Click to select " + what + ", Shift-click: add; drag a box (Alt: lasso) to select";
    }
    return "Click or drag a box (Alt: lasso) to select, drag to move, double-click a segment to insert a node";
}

} // namespace forefront
