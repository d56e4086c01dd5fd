#include "ui/tools/draw/round_tools.hpp"

#include "core/engine/base/number_text.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/common/tool_options.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/relation_options.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace forefront {

const char *RegularPolygonTool::icon() const {
    return icon::kRegular;
}

std::span<const EntryField> RegularPolygonTool::entryFields() const {
    static constexpr std::array kRadius{EntryField::Radius, EntryField::Angle};
    return centre_ ? std::span<const EntryField>(kRadius) : DrawingTool::entryFields();
}

Vec2 RegularPolygonTool::firstCorner(Vec2 at) const {
    const std::optional<double> radius = entry_.value(EntryField::Radius);
    // A typed radius without an angle means a corner on the right, wherever the pointer happens to be.
    return radius && !entry_.value(EntryField::Angle) ? *centre_ + Vec2{*radius, 0.0} : at;
}

std::vector<Vec2> RegularPolygonTool::corners(Vec2 first) const {
    std::vector<Vec2> result;
    const Vec2 arm = first - *centre_;
    for (int k = 0; k < sides_; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / sides_;
        result.push_back(k == 0 ? first : *centre_ + std::cos(angle) * arm + std::sin(angle) * leftNormal(arm));
    }
    return result;
}

void RegularPolygonTool::place(Vec2 at, Shell &context) {
    if (!centre_) {
        centre_ = at;
        return;
    }
    if (at == *centre_) {
        return; // second click of a double-click
    }
    Shape shape;
    shape.form = PathForm{};
    shape.nodes = corners(firstCorner(at));
    commitShape(context, std::move(shape), "Draw regular polygon");
    centre_.reset();
}

void RegularPolygonTool::keepFormulas(const Shape &drawn, const Keep &keep) const {
    const PlaceFormula centre = formulaOf(*centre_);
    const Vec2 arm = drawn.nodes.front() - *centre_;
    std::string radius = entry_.expression(EntryField::Radius), angle = entry_.expression(EntryField::Angle);
    radius = radius.empty() ? exactText(length(arm)) : radius;
    angle = angle.empty() ? degreesText(arm) : angle;
    for (int k = 0; k < sides_; ++k) {
        const PlaceFormula corner = polarFormula(centre, radius, sumFormula(angle, exactText(360.0 * k / sides_)));
        keep(Quantity::X, k, usesNames(corner.x) ? corner.x : std::string());
        keep(Quantity::Y, k, usesNames(corner.y) ? corner.y : std::string());
    }
}

void RegularPolygonTool::drawSketch(CanvasPainter &painter, Shell &context) {
    if (!centre_) {
        drawMeasure(painter, context, {});
        return;
    }
    const Theme &theme = context.theme;
    painter.handle(*centre_, 3.0, theme.canvas, theme.selection);
    const Vec2 first = firstCorner(pointer_.at);
    painter.polyline(corners(first), true, theme.selection, 2.0);
    painter.dashed(*centre_, first, fade(theme.selection, 0.6), 1.0);
    drawMeasure(painter, context, "r = " + ui::number(distance(*centre_, first)));
}

void RegularPolygonTool::drawOptions(Shell &context, ui::Flow &flow) {
    drawTagOption(context, flow, *state_, ShapeUse::Boundary, "Tag of the next boundary");
    double sides = sides_;
    constexpr double kMostSides = 1000.0;
    if (drawSizeOption(context, flow, "options/sides", "Sides", sides, "Number of sides of the next polygon") &&
        sides >= 3.0 && sides <= kMostSides) {
        sides_ = static_cast<int>(sides);
    }
    state_->drawSnapOptions(context, flow);
    drawRelationOptions(context, flow);
}

std::string RegularPolygonTool::statusText(const Shell &) const {
    return centre_ ? "Click a corner, or type the radius, Tab, angle, Enter. Shift: angle steps"
                   : "Click or drag from the centre, or type x, Tab, y, Enter. Inside another shape it becomes a hole";
}

} // namespace forefront
