#include "ui/workspace/edit_state.hpp"

#include "core/edit/formulas.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/workspace.hpp"

#include <imgui.h>

#include <cmath>

namespace forefront {

void SelectionFilter::apply(Selection &selection) const {
    if (!shapes) {
        selection.shapes.clear();
        selection.segments.clear();
    }
    if (!shapes || !nodes) {
        selection.nodes.clear();
    }
    if (!sources) {
        selection.sources.clear();
    }
    if (!markers) {
        selection.markers.clear();
    }
}

const std::shared_ptr<const PickIndex> &EditState::index(const Workspace &context) {
    const std::uint64_t revision = context.document.revision();
    if (!index_ || revision_ != revision) {
        index_ = std::make_shared<const PickIndex>(context.document.current());
        revision_ = revision;
    }
    return index_;
}

std::string EditState::newStroke() {
    return "stroke " + std::to_string(++strokes_);
}

bool EditState::apply(Workspace &context, Result<Document> next, const std::string &label, const std::string &merge) {
    if (!next) {
        context.log.add(next.faults());
        return false;
    }
    const EnteredFormula &entered = context.entered;
    if (entered.frame == ImGui::GetFrameCount()) {
        next = setFormula(*std::move(next), entered.address, entered.text);
    }
    context.document.apply(*std::move(next), label, merge);
    return true;
}

double EditState::reach(const Workspace &context, double designPixels) {
    return context.view.camera.length(static_cast<double>(context.px(designPixels)));
}

SnapQuery EditState::query(const Workspace &context, Vec2 place, bool angle, bool off) const {
    SnapQuery query;
    query.at = place;
    query.tolerance = reach(context, context.snapping.reach);
    query.gridPitch = context.snapping.toGrid ? gridPitch(reach(context, 1.0)) : 0.0;
    query.angle = angle;
    query.off = off;
    if (!context.snapping.toDrawing) {
        query.filter = [](const Shape &) { return false; };
    }
    return query;
}

void EditState::drawSnapOptions(Workspace &context, ui::Flow &flow) {
    flow.item("snap");
    ui::checkbox(context, "options/snap/drawing", "Snap to drawing", context.snapping.toDrawing);
    ui::tooltip(context, "Snap to nodes and segments. Hold Ctrl to turn snapping off, Shift for steps of 15\xc2\xb0.");
    ImGui::SameLine(0, context.px(12));
    ui::checkbox(context, "options/snap/grid", "Grid", context.snapping.toGrid);
}

void drawSnapMark(CanvasPainter &painter, const Workspace &context, const Snapped &snapped) {
    const Theme &theme = context.theme;
    switch (snapped.kind) {
    case SnapKind::Node:
        painter.handle(snapped.at, 5.5, fade(theme.selection, 0.25), theme.selection);
        break;
    case SnapKind::Segment:
        if (snapped.segment && snapped.segment->curve) {
            painter.curve(*snapped.segment->curve, fade(theme.selection, 0.6), 2.5);
        } else if (snapped.segment) {
            painter.line(snapped.segment->a, snapped.segment->b, fade(theme.selection, 0.6), 2.5);
        }
        painter.cross(snapped.at, 5.0, theme.selection, 1.5);
        break;
    case SnapKind::Grid: {
        const double arm = painter.camera().length(6.0 * painter.scale());
        painter.line(snapped.at - Vec2{arm, 0}, snapped.at + Vec2{arm, 0}, theme.muted, 1.0);
        painter.line(snapped.at - Vec2{0, arm}, snapped.at + Vec2{0, arm}, theme.muted, 1.0);
        break;
    }
    case SnapKind::Angle:
    case SnapKind::Locked:
        painter.ring(snapped.at, 4.0, theme.selection, 1.5);
        break;
    case SnapKind::None:
        break;
    }
}

double EditState::twoDigits(double value) {
    if (!(value > 0.0) || !std::isfinite(value)) {
        return value;
    }
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return std::round(value / unit) * unit;
}

} // namespace forefront
