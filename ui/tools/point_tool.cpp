#include "ui/tools/point_tool.hpp"

#include "core/edit/formulas.hpp"
#include "core/edit/region_commands.hpp"
#include "core/edit/region_fill.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/tool_options.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <cmath>
#include <string>
#include <utility>

namespace forefront {

const char *PointTool::icon() const {
    return icon::kPoint;
}

void PointTool::place(Vec2 at, Shell &context) {
    Shape shape;
    shape.kind = ShapeKind::Point;
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
}

const char *RegionTool::icon() const {
    return icon::kFlag;
}

void RegionTool::activate(Shell &context) {
    if (tag_ == 0) {
        tag_ = freeRegionTag(*context.document.current());
    }
}

void RegionTool::place(Vec2 at, Shell &context) {
    const std::shared_ptr<const Document> document = context.document.current();
    Result<Document> next = fillRegion(*document, at, tag_);
    if (next && !next->regionMarkers.empty()) {
        const std::string prefix = "region/" + std::to_string(next->regionMarkers.size() - 1) + '/';
        const PlaceFormula formula = formulaOf(at);
        for (const auto &[axis, text] : {std::pair('x', formula.x), std::pair('y', formula.y)}) {
            next = usesNames(text) ? setFormula(*std::move(next), prefix + axis, text) : std::move(next);
        }
    }
    if (EditState::apply(context, std::move(next), "Fill " + regionName(document->regionNames, tag_))) {
        context.selection.clear();
        const auto count = context.document.current()->regionMarkers.size();
        context.selection.markers.insert(static_cast<std::uint32_t>(count - 1));
    }
}

void RegionTool::drawSketch(CanvasPainter &painter, Shell &context) {
    if (over_) {
        const std::string name = regionName(context.document.current()->regionNames, tag_);
        painter.label(pointer_.at, {14.0, 10.0}, name, context.theme.text, fade(context.theme.popup, 0.9),
                      context.fonts.small);
    }
}

void RegionTool::drawOptions(Shell &context, ui::Flow &flow) {
    const std::shared_ptr<const Document> document = context.document.current();
    flow.item("tag");
    ImGui::AlignTextToFramePadding();
    ui::muted(context, "Region");
    ImGui::SameLine();
    double value = tag_;
    if (ui::inputNumber(context, "options/region/tag", value, 44.0F) && value >= 1.0 && value <= 1e9) {
        tag_ = static_cast<std::int32_t>(std::floor(value));
    }
    ui::tooltip(context, "Tag of the region to fill");
    flow.item("name");
    std::string name = regionName(document->regionNames, tag_);
    if (ui::entry(context, "options/region/name", name, "name", 140.0F, true)) {
        EditState::apply(context, setRegionName(*document, tag_, name), "Name region");
    }
    flow.item("new");
    if (ui::button(context, "options/region/new", "New region")) {
        tag_ = freeRegionTag(*document);
        if (tag_ < 2) {
            tag_ = 2;
        }
    }
}

} // namespace forefront
