#include "ui/tools/size/source_tool.hpp"

#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/engine/base/number_text.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/common/source_parts.hpp"
#include "ui/tools/common/tool_options.hpp"
#include "ui/widgets/enum_choice.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <array>
#include <string>
#include <utility>

namespace forefront {

const char *SourceTool::icon() const {
    return icon::kSource;
}

double SourceTool::size(const Shell &context, Vec2 at) const {
    if (const double held = state_->held(&EditState::sourceSize, context); held > 0.0) {
        return held;
    }
    const double rho = context.preview->spacing ? context.preview->spacing->at(at) : EditState::reach(context, 40.0);
    return roundedTo(0.25 * rho, 2);
}

void SourceTool::place(Vec2 at, Shell &context) {
    if (shape() == SourceShape::Point) {
        add(context, at, at);
    } else if (!first_) {
        first_ = at;
    } else if (const Vec2 second = corner(at); second != *first_) {
        add(context, *first_, second);
        first_.reset();
    }
}

Vec2 SourceTool::corner(Vec2 at) const {
    return shape() == SourceShape::Box && first_ ? cornerOfBox(*first_, at) : at;
}

void SourceTool::add(Shell &context, Vec2 a, Vec2 b) {
    SizeSource source;
    source.shape = shape();
    source.a = a;
    source.b = source.shape == SourceShape::Line || source.shape == SourceShape::Box ? b : a;
    source.radius = source.shape == SourceShape::Circle ? distance(a, b) : 0.0;
    source.size = size(context, a);
    state_->propose(&EditState::sourceSize, source.size, context); // or the next one nearby would be four times finer
    source.endSize = source.shape == SourceShape::Line ? state_->sourceEndSize : std::nullopt;
    source.growth = state_->sourceGrowth;
    source.name = freeSourceName(*context.document.current(), source.shape == SourceShape::Point  ? "point"
                                                              : source.shape == SourceShape::Line ? "line"
                                                              : source.shape == SourceShape::Box  ? "box"
                                                                                                  : "disc");
    Result<Document> next = addSource(*context.document.current(), source);
    if (next) {
        keepSourceFormulas(*next, source);
    }
    if (context.applyCommand(std::move(next), "Add size source")) {
        context.selection.clear();
        const auto count = context.document.current()->spacing.sources.size();
        context.selection.sources.insert(static_cast<std::uint32_t>(count - 1));
    }
}

void SourceTool::keepSourceFormulas(Document &document, const SizeSource &source) const {
    const auto index = static_cast<std::uint32_t>(document.spacing.sources.size() - 1);
    const auto keep = [&](Quantity what, const std::string &formula) {
        if (usesNames(formula)) {
            document = setFormula(std::move(document), {NumberOwner::ofSource(index), what}, formula);
        }
    };
    const PlaceFormula a = formulaOf(source.a), b = formulaOf(source.b);
    keep(Quantity::X, a.x);
    keep(Quantity::Y, a.y);
    if (source.shape == SourceShape::Box) {
        const auto far = [&](const std::string &near, double from, EntryField field) {
            const std::string extent = entry_.expression(field);
            return extent.empty() ? extent : (near.empty() ? exactText(from) : near) + "+(" + extent + ')';
        };
        keep(Quantity::X2, far(a.x, source.a.x, EntryField::Width));
        keep(Quantity::Y2, far(a.y, source.a.y, EntryField::Height));
    }
    if (source.shape == SourceShape::Line || source.shape == SourceShape::Box) {
        keep(Quantity::X2, b.x);
        keep(Quantity::Y2, b.y);
    } else if (source.shape == SourceShape::Circle) {
        keep(Quantity::Radius, entry_.expression(EntryField::Radius));
    }
    keep(Quantity::Size, state_->sourceSizeFormula);
    keep(Quantity::Growth, state_->sourceGrowthFormula);
}

std::span<const EntryField> SourceTool::entryFields() const {
    static constexpr std::array kRadius{EntryField::Radius};
    static constexpr std::array kSize{EntryField::Width, EntryField::Height};
    if (first_ && shape() == SourceShape::Box) {
        return kSize;
    }
    return first_ && shape() == SourceShape::Circle ? std::span<const EntryField>(kRadius) : DrawingTool::entryFields();
}

std::string_view SourceTool::goal() const {
    if (first_ || shape() == SourceShape::Point) {
        return "add the source";
    }
    return shape() == SourceShape::Line     ? "place the first end"
           : shape() == SourceShape::Circle ? "place the centre"
                                            : "place the first corner";
}

Vec2 SourceTool::typedPlace(const TypedPair &pair) const {
    // A pair typed after the first corner is width and height.
    return first_ && shape() == SourceShape::Box ? *first_ + pair.value : DrawingTool::typedPlace(pair);
}

void SourceTool::drawSketch(CanvasPainter &painter, Shell &context) {
    const Theme &theme = context.theme;
    if (!over_) {
        return;
    }
    const double rho = size(context, first_.value_or(pointer_.at));
    if (first_) {
        painter.dot(*first_, 4.0, theme.brush);
        if (shape() == SourceShape::Box) {
            painter.fillRectangle(boxOf(*first_, corner(pointer_.at)), fade(theme.brush, 0.12));
            painter.rectangle(boxOf(*first_, corner(pointer_.at)), theme.brush, 2.0);
        } else if (shape() == SourceShape::Circle) {
            painter.circle(*first_, distance(*first_, pointer_.at), theme.brush, 2.0);
        } else {
            painter.line(*first_, pointer_.at, theme.brush, 2.0);
        }
    }
    std::string text = "\xcf\x81=" + ui::number(rho, 3);
    if (first_ && shape() == SourceShape::Box) {
        const Vec2 size = boxOf(*first_, corner(pointer_.at)).size();
        text = ui::number(size.x) + " \xc3\x97 " + ui::number(size.y) + "  " + text;
    } else if (first_) {
        text = (shape() == SourceShape::Circle ? "r=" : "") + ui::number(distance(*first_, pointer_.at)) + "  " + text;
    }
    drawMeasure(painter, context, text);
}

void SourceTool::drawOptions(Shell &context, ui::Flow &flow) {
    flow.item("shape");
    if (ui::segmented(context, "options/source/shape", state_->sourceShape, 204.0F)) {
        cancel();
    }
    double shown = size(context, first_.value_or(over_ ? pointer_.at : context.view.camera.centre));
    if (drawFormulaOption(context, flow, "options/source/size", "Size", shown, state_->sourceSizeFormula,
                          "Element size at the source", false, context.document.current()->unit) ||
        !state_->sourceSizeFormula.empty()) {
        state_->sourceSize = shown;
    }
    if (shape() == SourceShape::Line) {
        drawOptionalSizeOption(context, flow, "options/source/endsize", "End size", state_->sourceEndSize, "same",
                               "Element size at the second end of the line. The size changes linearly along the line. "
                               "Leave empty for the same size everywhere.");
    }
    drawFormulaOption(context, flow, "options/source/growth", "Growth", state_->sourceGrowth,
                      state_->sourceGrowthFormula,
                      "Growth of the spacing per unit of distance: 0.1 is gentle, 0.3 is steep", false);
    state_->drawSnapOptions(context, flow);
}

std::string SourceTool::statusText(const Shell &) const {
    switch (shape()) {
    case SourceShape::Point:
        return "Click where the elements should be small, or type x, Tab, y, Enter";
    case SourceShape::Line:
        return first_ ? "Click the other end, or type distance, Tab, angle, Enter"
                      : "Click or drag from one end of a line along which the elements should be small, or type x, "
                        "Tab, y, Enter";
    case SourceShape::Circle:
        return first_ ? "Click a point on the circle, or type the radius, Enter, or D, the diameter, Enter"
                      : "Click or drag from the centre of a disc, or type x, Tab, y, Enter. The elements will be small "
                        "inside it";
    case SourceShape::Box:
        return first_ ? "Click the opposite corner, or type width, Tab, height, Enter. Shift: square"
                      : "Click or drag from a corner of a box, or type x, Tab, y, Enter. The elements will be small "
                        "inside it. Shift: square";
    }
    return {};
}

} // namespace forefront
