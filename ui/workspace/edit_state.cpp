#include "ui/workspace/edit_state.hpp"

#include "core/edit/formulas.hpp"
#include "core/edit/name_commands.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/workspace.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

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

std::int32_t EditState::tagOfNext(ShapeUse use, const Document &document) const {
    const bool boundary = use == ShapeUse::Boundary;
    const std::optional<std::int32_t> &chosen = boundary ? boundaryTag : constraintTag;
    constexpr std::int32_t kBoundary = 1, kConstraint = 2;
    const std::int32_t usual = boundary ? kBoundary : kConstraint;
    const bool special = document.boundaryNames.contains(usual) || document.elementCounts.contains(usual) ||
                         document.spacing.partSizes.contains(usual);
    return chosen.value_or(special ? std::max(freeBoundaryTag(document), kConstraint + 1) : usual);
}

void EditState::forgetNumbers() {
    const EditState initial;
    boundaryTag = initial.boundaryTag;
    constraintTag = initial.constraintTag;
    freehandTolerance = initial.freehandTolerance;
    brushRadius = initial.brushRadius;
    brushSpacing = initial.brushSpacing;
    sourceSize = initial.sourceSize;
    sourceEndSize = initial.sourceEndSize;
    sourceGrowth = initial.sourceGrowth;
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
    ui::tooltip(context, "Snap to nodes, midpoints, centres, crossings, perpendiculars, tangents and segments. Hold "
                         "Ctrl to turn snapping off, Shift for steps of 15\xc2\xb0.");
    ImGui::SameLine(0, context.px(12));
    ui::checkbox(context, "options/snap/grid", "Snap to grid", context.snapping.toGrid);
    ui::tooltip(context, "Snap to the points of the drawing grid. The layer Grid shows the grid or hides it.");
}

namespace {

/// Draws the glyph of a special point: a triangle on a midpoint, a ring with a dot on a centre, a cross on an
/// intersection, a right angle, or a circle on a tangent.
void drawSpecialMark(CanvasPainter &painter, Colour colour, const Snapped &snapped) {
    const Vec2 at = snapped.at;
    const double r = painter.camera().length(6.0 * painter.scale());
    switch (snapped.kind) {
    case SnapKind::Midpoint:
        painter.polyline(std::array<Vec2, 3>{at + Vec2{-r, -r}, at + Vec2{r, -r}, at + Vec2{0.0, r}}, true, colour,
                         1.5);
        break;
    case SnapKind::Centre:
        painter.ring(at, 6.0, colour, 1.5);
        painter.dot(at, 2.0, colour);
        break;
    case SnapKind::Intersection:
        painter.cross(at, 7.0, colour, 2.0);
        break;
    case SnapKind::Perpendicular:
        painter.polyline(std::array<Vec2, 3>{at + Vec2{-r, r}, at + Vec2{-r, -r}, at + Vec2{r, -r}}, false, colour,
                         1.5);
        painter.polyline(std::array<Vec2, 3>{at + Vec2{-r, 0.0}, at, at + Vec2{0.0, -r}}, false, colour, 1.0);
        break;
    default:
        painter.ring(at, 5.0, colour, 1.5);
        painter.line(at + Vec2{-r, r}, at + Vec2{r, r}, colour, 1.5);
        break;
    }
}

} // namespace

void drawSnapMark(CanvasPainter &painter, const Workspace &context, const Snapped &snapped) {
    const Theme &theme = context.theme;
    if (const std::string_view word = wordOf(snapped.kind); !word.empty()) {
        painter.label(snapped.at, {16.0, -30.0}, word, theme.selection, fade(theme.popup, 0.9), context.fonts.small);
    }
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
    case SnapKind::Midpoint:
    case SnapKind::Centre:
    case SnapKind::Intersection:
    case SnapKind::Perpendicular:
    case SnapKind::Tangent:
        drawSpecialMark(painter, theme.selection, snapped);
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
