#include "ui/tools/measure_tool.hpp"

#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"

#include <cmath>
#include <numbers>

namespace forefront {

const char *MeasureTool::icon() const {
    return "\xef\x81\xbe"; // Font Awesome: arrows-h
}

void MeasureTool::place(Vec2 at, Shell &) {
    if (points_.size() == 2) {
        points_.clear();
    }
    if (points_.empty() || at != points_.front()) {
        points_.push_back(at);
    }
}

std::string MeasureTool::reading() const {
    if (points_.empty()) {
        return {};
    }
    const Vec2 arm = (points_.size() == 2 ? points_[1] : pointer_.at) - points_[0];
    const double angle = std::atan2(arm.y, arm.x) * 180.0 / std::numbers::pi;
    return ui::number(length(arm), 6) + "   \xce\x94x " + ui::number(arm.x, 6) + "   \xce\x94y " +
           ui::number(arm.y, 6) + "   \xe2\x88\xa0 " + ui::number(angle, 4) + "\xc2\xb0";
}

void MeasureTool::drawSketch(CanvasPainter &painter, Shell &context) {
    const Theme &theme = context.theme;
    if (points_.empty()) {
        drawMeasure(painter, context, {});
        return;
    }
    const Vec2 from = points_[0], to = points_.size() == 2 ? points_[1] : pointer_.at;
    painter.line(from, to, theme.selection, 1.5);
    painter.dashed(from, {to.x, from.y}, fade(theme.selection, 0.5), 1.0);
    painter.dashed({to.x, from.y}, to, fade(theme.selection, 0.5), 1.0);
    for (const Vec2 end : {from, to}) {
        painter.cross(end, 4.0, theme.selection, 1.5);
    }
    if (points_.size() == 2) {
        painter.label(to, {16.0, 14.0}, reading(), theme.text, fade(theme.popup, 0.9), context.fonts.small);
    } else {
        drawMeasure(painter, context, reading());
    }
}

void MeasureTool::drawOptions(Shell &context, ui::Flow &flow) {
    state_->drawSnapOptions(context, flow);
}

std::string MeasureTool::statusText(const Shell &) const {
    return points_.size() == 1 ? "Click the second point. Shift: steps of 15\xc2\xb0"
                               : "Click or drag from point to point to measure";
}

} // namespace forefront
