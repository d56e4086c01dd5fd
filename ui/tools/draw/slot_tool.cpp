#include "ui/tools/draw/slot_tool.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/shapes/slot.hpp"
#include "core/engine/geometry/polygon.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/common/tool_options.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/relation_options.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

namespace forefront {
namespace {

/// Returns twice an expression; twice w/2 is w.
std::string doubled(const std::string &text) {
    const bool half = text.ends_with("/2");
    const std::string whole = half ? text.substr(0, text.size() - 2) : std::string();
    const bool isName = !whole.empty() && std::all_of(whole.begin(), whole.end(),
                                                      [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
    return isName ? whole : "2*(" + text + ")";
}

} // namespace

const char *SlotTool::icon() const {
    return icon::kSlot;
}

std::span<const EntryField> SlotTool::entryFields() const {
    static constexpr std::array kRadius{EntryField::Radius};
    return centres_.size() == 2 ? std::span<const EntryField>(kRadius) : DrawingTool::entryFields();
}

std::string_view SlotTool::goal() const {
    return centres_.empty()       ? "place the first centre"
           : centres_.size() == 1 ? "place the second centre"
                                  : "draw the slot";
}

double SlotTool::radiusTo(Vec2 at) const {
    const double reach = distanceToSegment(centres_[0], centres_[1], at);
    return entry_.value(EntryField::Radius).value_or(reach);
}

std::string SlotTool::typedLength() const {
    const std::string size = entry_.expression(EntryField::Distance);
    if (centres_.empty() || entry_.pair() || !usesNames(size) || usesNames(entry_.expression(EntryField::Angle)) ||
        entry_.value(EntryField::X) || entry_.value(EntryField::Y)) {
        return {};
    }
    const PlaceFormula from = formulaOf(centres_.front());
    return usesNames(from.x) || usesNames(from.y) ? std::string() : size;
}

void SlotTool::keepFormulas(const Shape &drawn, const Keep &keep) const {
    // The length alone keeps its direction, also when the slot is moved; otherwise both centres follow.
    DrawingTool::keepFormulas(drawn, [&](Quantity what, std::uint32_t handle, const std::string &formula) {
        if (length_.empty() || handle == 0) {
            keep(what, handle, formula);
        }
    });
    keep(Quantity::Length, 0, length_);
    const std::string diameter = entry_.expression(EntryField::Diameter);
    const std::string radius = entry_.expression(EntryField::Radius);
    const std::string width = !diameter.empty() ? diameter : doubled(radius);
    keep(Quantity::Width, 0, usesNames(width) ? width : std::string());
}

bool SlotTool::removeLast() {
    if (centres_.empty()) {
        return false;
    }
    centres_.pop_back();
    return true;
}

void SlotTool::place(Vec2 at, Shell &context) {
    if (centres_.size() < 2) {
        if (centres_.empty() || at != centres_.front()) {
            length_ = typedLength();
            centres_.push_back(at);
        }
        return;
    }
    const double radius = radiusTo(at);
    if (radius > 0.0 && commitShape(context, slotAround(centres_[0], centres_[1], radius), "Draw slot")) {
        centres_.clear();
    }
}

void SlotTool::drawSketch(CanvasPainter &painter, Shell &context) {
    const Theme &theme = context.theme;
    std::string measure;
    if (centres_.size() == 1) {
        painter.dashed(centres_[0], pointer_.at, fade(theme.selection, 0.6), 1.5);
        measure = ui::number(distance(centres_[0], pointer_.at));
    } else if (centres_.size() == 2) {
        const double radius = radiusTo(pointer_.at);
        painter.dashed(centres_[0], centres_[1], fade(theme.selection, 0.6), 1.0);
        if (radius > 0.0) {
            painter.outline(outlineOf(slotAround(centres_[0], centres_[1], radius)), theme.selection, 2.0);
        }
        measure = "r = " + ui::number(radius);
    }
    for (const Vec2 centre : centres_) {
        painter.handle(centre, 3.0, theme.canvas, theme.selection);
    }
    drawMeasure(painter, context, measure);
}

void SlotTool::drawOptions(Shell &context, ui::Flow &flow) {
    drawTagOption(context, flow, *state_, ShapeUse::Boundary, "Tag of the next boundary");
    state_->drawSnapOptions(context, flow);
    drawRelationOptions(context, flow);
}

std::string SlotTool::statusText(const Shell &) const {
    switch (centres_.size()) {
    case 0:
        return "Click the centre of one end, or type x, Tab, y, Enter. Inside another shape it becomes a hole";
    case 1:
        return "Click the centre of the other end, or type the length between the centres, Tab, angle, Enter. "
               "Position: 4,3";
    default:
        return "Click a point on the side, or type the radius of the ends, Enter, or D, the width, Enter. "
               "Backspace: remove the last centre";
    }
}

} // namespace forefront
