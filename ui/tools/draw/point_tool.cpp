#include "ui/tools/draw/point_tool.hpp"

#include "ui/parts/shell.hpp"
#include "ui/tools/common/tool_options.hpp"
#include "ui/workspace/relation_options.hpp"

#include <utility>

namespace forefront {

const char *PointTool::icon() const {
    return icon::kPoint;
}

void PointTool::place(Vec2 at, Shell &context) {
    Shape shape;
    shape.form = PointForm{};
    shape.use = ShapeUse::Constraint;
    shape.nodes = {at};
    commitShape(context, std::move(shape), "Place point");
}

void PointTool::drawSketch(CanvasPainter &painter, Shell &context) {
    drawMeasure(painter, context, {});
}

void PointTool::drawOptions(Shell &context, ui::Flow &flow) {
    drawTagOption(context, flow, *state_, ShapeUse::Constraint, "Tag of the next point");
    state_->drawSnapOptions(context, flow);
    drawRelationOptions(context, flow);
}

} // namespace forefront
