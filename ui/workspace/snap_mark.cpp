#include "ui/workspace/snap_mark.hpp"

#include "core/drawing/picking/pointer_snap.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/canvas/constraint_glyphs.hpp"
#include "ui/workspace/workspace.hpp"

#include <array>
#include <string>

namespace forefront {
namespace {

/// Half the width of a glyph in design pixels; it must show around the handle of a dragged node.
constexpr double kReach = 9.0;

/// Highlights the segment that a point snapped to.
void drawTarget(CanvasPainter &painter, Colour colour, const SegmentHit &segment) {
    if (segment.curve) {
        painter.curve(*segment.curve, fade(colour, 0.6), 2.5);
    } else {
        painter.line(segment.a, segment.b, fade(colour, 0.6), 2.5);
    }
}

/// Draws a bar along a direction through a place, with a tick at each end: the point can move only along it.
void drawRail(CanvasPainter &painter, Vec2 at, Vec2 along, Colour colour) {
    const double arm = painter.camera().length(18.0 * painter.scale()), tick = 0.25 * arm;
    const Vec2 across{-along.y, along.x};
    painter.line(at - arm * along, at + arm * along, colour, 1.5);
    for (const double end : {-arm, arm}) {
        painter.line(at + end * along - tick * across, at + end * along + tick * across, colour, 1.5);
    }
}

/// Draws an angle with its arc, above and to the right of a place.
void drawAngleGlyph(CanvasPainter &painter, Vec2 at, Colour colour) {
    const double r = painter.camera().length(9.0 * painter.scale());
    painter.ring(at, 3.5, colour, 1.5);
    painter.polyline(std::array<Vec2, 3>{at + Vec2{r, 0.8 * r}, at, at + Vec2{1.3 * r, 0.0}}, false, colour, 1.5);
    painter.polyline(
        std::array<Vec2, 3>{at + Vec2{0.55 * r, 0.44 * r}, at + Vec2{0.68 * r, 0.25 * r}, at + Vec2{0.72 * r, 0.0}},
        false, colour, 1.5);
}

/// Draws what is locked: a rail along the coordinate that is free, or a ring where none is; a locked length or angle
/// shows the line that it belongs to.
void drawLockGlyph(CanvasPainter &painter, const Snapped &snapped, Colour colour) {
    const SnapLocks &locks = snapped.locks;
    if (locks.x && !locks.y) {
        drawRail(painter, snapped.at, {0.0, 1.0}, colour);
    } else if (locks.y && !locks.x) {
        drawRail(painter, snapped.at, {1.0, 0.0}, colour);
    } else if (locks.angle && !locks.x) {
        drawAngleGlyph(painter, snapped.at, colour);
    }
    painter.ring(snapped.at, 0.8 * kReach, colour, 1.5);
}

/// Draws a triangle on a midpoint, a ring with a dot on a centre, a cross on an intersection, a right angle on a
/// perpendicular, or a circle on a tangent.
void drawSpecialMark(CanvasPainter &painter, Colour colour, const Snapped &snapped) {
    const Vec2 at = snapped.at;
    const double r = painter.camera().length(kReach * painter.scale());
    switch (snapped.kind) {
    case SnapKind::Midpoint:
        painter.polyline(std::array<Vec2, 3>{at + Vec2{-r, -r}, at + Vec2{r, -r}, at + Vec2{0.0, r}}, true, colour,
                         1.5);
        break;
    case SnapKind::Centre:
        painter.ring(at, kReach, colour, 1.5);
        painter.dot(at, 2.0, colour);
        break;
    case SnapKind::Intersection:
        painter.cross(at, kReach, colour, 2.0);
        break;
    case SnapKind::Perpendicular:
        painter.polyline(std::array<Vec2, 3>{at + Vec2{-r, r}, at + Vec2{-r, -r}, at + Vec2{r, -r}}, false, colour,
                         1.5);
        painter.polyline(std::array<Vec2, 3>{at + Vec2{-r, 0.0}, at, at + Vec2{0.0, -r}}, false, colour, 1.0);
        break;
    default:
        painter.ring(at, 0.8 * kReach, colour, 1.5);
        painter.line(at + Vec2{-r, r}, at + Vec2{r, r}, colour, 1.5);
        break;
    }
}

void drawGlyph(CanvasPainter &painter, const Theme &theme, const Snapped &snapped) {
    const double arm = painter.camera().length(1.2 * kReach * painter.scale());
    switch (snapped.kind) {
    case SnapKind::Node:
        painter.handle(snapped.at, 0.9 * kReach, fade(theme.selection, 0.25), theme.selection);
        break;
    case SnapKind::Segment:
        drawTarget(painter, theme.selection, *snapped.segment);
        painter.cross(snapped.at, 0.9 * kReach, theme.selection, 1.5);
        break;
    case SnapKind::Midpoint:
    case SnapKind::Centre:
    case SnapKind::Intersection:
    case SnapKind::Perpendicular:
    case SnapKind::Tangent:
        drawSpecialMark(painter, theme.selection, snapped);
        break;
    case SnapKind::Guide:
    case SnapKind::Grid:
        painter.line(snapped.at - Vec2{arm, 0}, snapped.at + Vec2{arm, 0}, theme.selection, 1.5);
        painter.line(snapped.at - Vec2{0, arm}, snapped.at + Vec2{0, arm}, theme.selection, 1.5);
        break;
    case SnapKind::Angle:
        drawAngleGlyph(painter, snapped.at, theme.selection);
        break;
    case SnapKind::Locked:
        drawLockGlyph(painter, snapped, theme.selection);
        break;
    case SnapKind::Inferred:
        painter.ring(snapped.at, 0.5 * kReach, theme.selection, 1.5);
        break;
    case SnapKind::None:
        break;
    }
}

/// Draws the guide lines of the relations that a point fulfils, and the other lines that they are about.
void drawRelations(CanvasPainter &painter, const Workspace &context, const Snapped &snapped) {
    const Colour colour = fade(context.theme.selection, 0.6);
    for (const Inference &relation : snapped.inferred) {
        painter.dashed(relation.start, snapped.at, colour, 1.0);
        const Shape *const shape =
            relation.with && relation.ofLine ? findShape(*context.document.current(), relation.with->shape) : nullptr;
        const Outline outline = shape != nullptr ? outlineOf(*shape) : Outline();
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            if (outline.part(k) == relation.with->index) {
                painter.curve(outline.curve(k), colour, 2.5);
            }
        }
        if (!relation.ofLine) {
            painter.ring(relation.start, 5.0, colour, 1.5);
        }
    }
}

/// Returns the glyphs of the relations of a point, as text.
std::string glyphsOf(const Snapped &snapped) {
    std::string glyphs;
    for (const Inference &relation : snapped.inferred) {
        glyphs += glyphOf(relation.kind);
    }
    return glyphs;
}

} // namespace

void drawSnapMark(CanvasPainter &painter, const Workspace &context, const Snapped &snapped) {
    const Theme &theme = context.theme;
    if (snapped.from) {
        painter.dashed(*snapped.from, snapped.at, fade(theme.selection, 0.6), 1.0);
    }
    const bool inferred = snapped.kind == SnapKind::Inferred;
    if (inferred || context.snapping.addsConstraints) {
        drawRelations(painter, context, snapped);
    }
    drawGlyph(painter, theme, snapped);
    const std::string glyphs = inferred || context.snapping.addsConstraints ? glyphsOf(snapped) : std::string();
    if (const std::string words = glyphs + (glyphs.empty() ? "" : " ") + wordsOf(snapped); !words.empty()) {
        painter.label(snapped.at, {16.0, -30.0}, words, theme.selection, fade(theme.popup, 0.9), context.fonts.small);
    }
}

} // namespace forefront
