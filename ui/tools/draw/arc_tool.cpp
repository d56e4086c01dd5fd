#include "ui/tools/draw/arc_tool.hpp"

#include "core/drawing/shapes/plane_map.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/common/tool_options.hpp"
#include "ui/widgets/enum_choice.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/relation_options.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace forefront {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;

/// Returns the angle from one direction to another, at least 0 and less than a full turn.
double turnBetween(Vec2 from, Vec2 to) {
    const double angle = std::atan2(cross(from, to), dot(from, to));
    return angle < 0.0 ? angle + kFullTurn : angle;
}

} // namespace

const char *ArcTool::icon() const {
    return icon::kArc;
}

std::optional<Vec2> ArcTool::anchor() const {
    return places_.empty() ? std::nullopt : std::optional(byCentre() ? places_.front() : places_.back());
}

std::span<const EntryField> ArcTool::entryFields() const {
    static constexpr std::array kRadius{EntryField::Radius};
    static constexpr std::array kStart{EntryField::Radius, EntryField::Angle};
    static constexpr std::array kEnd{EntryField::Angle};
    if (byCentre() && !places_.empty()) {
        return places_.size() == 1 ? std::span<const EntryField>(kStart) : std::span<const EntryField>(kEnd);
    }
    return places_.size() == 2 ? std::span<const EntryField>(kRadius) : DrawingTool::entryFields();
}

std::string_view ArcTool::goal() const {
    if (places_.size() == 2) {
        return "draw the arc";
    }
    if (byCentre()) {
        return places_.empty() ? "place the centre" : "place the start";
    }
    return places_.empty() ? "place the start" : "place the end";
}

Vec2 ArcTool::fitted(Vec2 at) {
    if (!byCentre() || places_.size() < 2) {
        return at;
    }
    const std::optional<double> typed = entry_.value(EntryField::Angle);
    const Vec2 centre = places_[0], start = places_[1] - centre, arm = typed ? unitVector(*typed) : at - centre;
    if (!(length(arm) > 0.0)) {
        return places_[1];
    }
    const double ahead = turnBetween(start, arm);
    if (typed) {
        turn_ = turn_ < 0.0 && ahead > 0.0 ? ahead - kFullTurn : ahead; // in the direction of the hand
    } else {
        turn_ = std::abs(ahead - turn_) <= std::abs(ahead - kFullTurn - turn_) ? ahead : ahead - kFullTurn;
    }
    return completed(at).point(1.0);
}

Curve ArcTool::completed(Vec2 at) const {
    if (byCentre()) {
        const Vec2 arm = places_[1] - places_[0];
        return Curve::arc(places_[0], arm, leftNormal(arm), 0.0, turn_);
    }
    const std::optional<double> radius = entry_.value(EntryField::Radius);
    return radius ? arcOfRadius(places_[0], places_[1], *radius, at) : arcThrough(places_[0], at, places_[1]);
}

bool ArcTool::removeLast() {
    if (places_.empty()) {
        return false;
    }
    places_.pop_back();
    return true;
}

void ArcTool::place(Vec2 at, Shell &context) {
    if (places_.size() < 2) {
        if (!places_.empty() && at == places_.front()) {
            return; // second click of a double-click
        }
        centre_ = formulaOf(places_.empty() ? at : places_.front());
        radius_ = {entry_.expression(EntryField::Radius), {}};
        places_.push_back(at);
        turn_ = 0.0;
        return;
    }
    const Curve curve = completed(at);
    Shape shape;
    shape.form = PathForm{.closed = false};
    shape.use = ShapeUse::Constraint;
    shape.nodes = byCentre() ? std::vector{places_[1], curve.point(1.0)} : places_;
    if (shape.nodes[0] == shape.nodes[1]) {
        return;
    }
    if (curve.kind() != CurveKind::Line) {
        shape.path().curves = {curve};
    }
    if (commitShape(context, std::move(shape), "Draw arc")) {
        places_.clear();
    }
}

bool ArcTool::followsEntry() const {
    // The ends follow the centre and the radius, but not an angle: the arc between them could be either of two.
    return byCentre() && !places_.empty() ? !usesNames(entry_.expression(EntryField::Angle))
                                          : DrawingTool::followsEntry();
}

void ArcTool::keepFormulas(const Shape &drawn, const Keep &keep) const {
    const auto named = [](const std::string &text) { return usesNames(text) ? text : std::string(); };
    if (!byCentre()) {
        DrawingTool::keepFormulas(drawn, keep);
        keep(Quantity::ArcRadius, 0, named(entry_.expression(EntryField::Radius)));
        return;
    }
    const double radius = distance(places_[0], places_[1]);
    const std::string size = radius_.x.empty() ? exactText(radius) : radius_.x;
    for (const std::uint32_t k : {0U, 1U}) {
        const PlaceFormula end = polarFormula(centre_, size, degreesText(drawn.nodes[k] - places_[0]));
        keep(Quantity::X, k, named(end.x));
        keep(Quantity::Y, k, named(end.y));
    }
    keep(Quantity::ArcRadius, 0, named(size));
}

std::string ArcTool::measure() const {
    if (places_.empty()) {
        return {};
    }
    const double reach = distance(places_.front(), pointer_.at);
    if (places_.size() == 1) {
        return (byCentre() ? "r = " : "") + ui::number(reach);
    }
    if (byCentre()) {
        return "r = " + ui::number(distance(places_[0], places_[1])) + "  \xe2\x88\xa0 " +
               ui::number(turn_ * 360.0 / kFullTurn, 4) + "\xc2\xb0";
    }
    const std::optional<double> radius = radiusOf(completed(pointer_.at));
    return radius ? "r = " + ui::number(*radius) : std::string("straight");
}

void ArcTool::drawSketch(CanvasPainter &painter, Shell &context) {
    const Theme &theme = context.theme;
    if (places_.size() == 1) {
        painter.dashed(places_[0], pointer_.at, fade(theme.selection, 0.6), 1.5);
        if (byCentre()) {
            painter.circle(places_[0], distance(places_[0], pointer_.at), fade(theme.selection, 0.3), 1.0);
        }
    } else if (places_.size() == 2) {
        painter.curve(completed(pointer_.at), theme.selection, 2.0);
        if (byCentre()) {
            painter.dashed(places_[0], pointer_.at, fade(theme.selection, 0.6), 1.0);
        }
    }
    for (const Vec2 place : places_) {
        painter.handle(place, 3.0, theme.canvas, theme.selection);
    }
    drawMeasure(painter, context, measure());
}

void ArcTool::drawOptions(Shell &context, ui::Flow &flow) {
    flow.item("arc");
    if (ui::segmented(context, "options/arc", state_->arcMode, std::min(200.0F, flow.room() / context.scale))) {
        cancel();
    }
    ui::tooltip(context, "Three points: both ends, then a point between them. Centre: the centre, then both ends; move "
                         "around the centre in the direction of the arc.");
    drawTagOption(context, flow, *state_, ShapeUse::Constraint, "Tag of the next inner line");
    state_->drawSnapOptions(context, flow);
    drawRelationOptions(context, flow);
}

std::string ArcTool::statusText(const Shell &) const {
    switch (places_.size()) {
    case 0:
        return byCentre() ? "Click the centre of the arc, or type x, Tab, y, Enter"
                          : "Click where the arc begins, or type x, Tab, y, Enter";
    case 1:
        return byCentre() ? "Click where the arc begins, or type the radius, Tab, angle, Enter"
                          : "Click where the arc ends, or type distance, Tab, angle, Enter. Position: 4,3";
    default:
        return byCentre() ? "Move around the centre and click where the arc ends, or type the direction of its end "
                            "as an angle, Enter. Backspace: remove the start"
                          : "Click a point on the arc, or point to its side and type the radius, Enter. Backspace: "
                            "remove the last end";
    }
}

} // namespace forefront
