#include "ui/panels/inspector_marks.hpp"

#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/name_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/engine/spacing/spec/source_box.hpp"
#include "ui/panels/form.hpp"
#include "ui/panels/mapped_rows.hpp"
#include "ui/panels/part_rows.hpp"
#include "ui/panels/size_rows.hpp"
#include "ui/panels/source_growth.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/measure_colours.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/mark_region.hpp"
#include "ui/workspace/typed_length.hpp"

#include <imgui.h>

#include <memory>
#include <optional>

namespace forefront {

void inspectorHeading(WidgetContext &context, const std::string &text) {
    ImGui::PushFont(context.fonts.strong);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopFont();
    ui::mark(context, "inspector/what");
}

void inspectSource(Shell &context, std::uint32_t index) {
    const Document &document = *context.document.current();
    SizeSource source = document.spacing.sources[index];
    inspectorHeading(context, displayName(source, index));
    const auto address = [&](Quantity what) { return NumberAddress{NumberOwner::ofSource(index), what}; };
    bool changed = form::text(context, "inspector/name", "Source name", source.name, "pier head");
    if (source.shape == SourceShape::Box) {
        changed =
            form::pair(context, "inspector/a", "Corner", source.a, {address(Quantity::X), address(Quantity::Y)}) ||
            changed;
        changed =
            form::pair(context, "inspector/b", "Opposite", source.b, {address(Quantity::X2), address(Quantity::Y2)}) ||
            changed;
        Vec2 extent = boxExtent(source);
        if (form::pair(context, "inspector/extent", "Width, height", extent,
                       {address(Quantity::Width), address(Quantity::Height)})) {
            resizeBox(source, extent);
            changed = true;
        }
        double angle = source.angle;
        if (form::number(context, "inspector/angle", "Angle", angle, address(Quantity::Angle))) {
            turnBox(source, angle);
            changed = true;
        }
    } else if (source.shape == SourceShape::Line) {
        changed = form::pair(context, "inspector/a", "From", source.a, {address(Quantity::X), address(Quantity::Y)}) ||
                  changed;
        changed = form::pair(context, "inspector/b", "To", source.b, {address(Quantity::X2), address(Quantity::Y2)}) ||
                  changed;
    } else {
        changed = form::pair(context, "inspector/a", source.shape == SourceShape::Circle ? "Centre" : "Position",
                             source.a, {address(Quantity::X), address(Quantity::Y)}) ||
                  changed;
    }
    if (source.shape != SourceShape::Box || source.radius != 0.0) {
        changed =
            form::number(context, "inspector/radius", "Radius", source.radius, address(Quantity::Radius)) || changed;
    }
    changed = form::number(context, "inspector/size", "Size \xcf\x81", source.size, address(Quantity::Size)) || changed;
    if (source.shape == SourceShape::Line) {
        form::label(context, "End size");
        changed = form::optionalField(context, "inspector/endsize", source.endSize, "same", -1.0F,
                                      address(Quantity::EndSize)) ||
                  changed;
        ui::rowTooltip(context, "Element size at the second end (To). The size changes linearly along the line. Leave "
                                "empty for the same size everywhere.");
    }
    changed = drawSourceGrowth(context, source, address(Quantity::Growth)) || changed;
    if (changed) {
        context.applyCommand(replaceSource(document, index, source), "Change source");
    }
    if (ui::button(context, "inspector/delete", "Delete")) {
        context.actions.run("edit.delete", context);
    }
}

namespace {

/// Draws the area of the face around a place, with the colour of its region.
void areaRow(Shell &context, Vec2 place, ImU32 colour) {
    const std::shared_ptr<const FaceMap> &faces = context.preview->faces;
    const std::uint32_t face = faces ? faces->faceAt(place) : kNoIndex;
    form::label(context, "Area");
    const float side = ImGui::GetTextLineHeight(),
                top = ImGui::GetCursorScreenPos().y + ImGui::GetStyle().FramePadding.y;
    const ImVec2 corner{ImGui::GetCursorScreenPos().x, top};
    ImGui::GetWindowDrawList()->AddRectFilled(corner, {corner.x + side, corner.y + side}, colour, context.px(3));
    ImGui::Dummy({side, 0.0F});
    ui::mark(context, "inspector/swatch");
    ImGui::SameLine(0, context.px(8));
    ImGui::AlignTextToFramePadding();
    const std::string area =
        face == kNoIndex ? std::string("not in a face")
                         : ui::grouped(faces->faces()[face].area, 6) + areaSuffix(context.document.current()->unit);
    ImGui::TextUnformatted(area.c_str());
    ui::mark(context, "inspector/area");
    ui::rowTooltip(context, "Area of the face, to its curves and without its holes");
}

/// Draws the command that selects the border of the face.
void borderButton(Shell &context) {
    if (ui::button(context, "inspector/border", "Select border")) {
        context.actions.run("edit.selectBorder", context);
    }
    ui::tooltip(context, "Selects the lines around the face, to name, move or divide them");
}

} // namespace

void inspectRegion(Shell &context, std::uint32_t index) {
    const Document &document = *context.document.current();
    const MarkedRegion marker = document.regionMarkers[index];
    inspectorHeading(context, regionName(document.regionNames, marker.tag));
    areaRow(context, marker.at, regionColour(marker.tag));
    const auto address = [&](Quantity what) { return NumberAddress{NumberOwner::ofRegion(index), what}; };
    Vec2 at = marker.at;
    if (form::pair(context, "inspector/at", "Position", at, {address(Quantity::X), address(Quantity::Y)})) {
        context.applyCommand(moveRegionMarker(document, index, at), "Move region marker");
        return;
    }
    std::optional<std::string> rename;
    std::int32_t tag = marker.tag;
    if (form::tag(context, "inspector/tag", "Region tag", tag, regionName(document.regionNames, tag), rename)) {
        context.applyCommand(setRegionTag(document, index, tag), "Change region");
    } else if (rename) {
        context.applyCommand(nameRegionOf(document, index, *rename), "Name region");
    }
    std::optional<double> area = marker.maxArea > 0.0 ? std::optional(marker.maxArea) : std::nullopt;
    form::label(context, "Max. area");
    if (form::optionalField(context, "inspector/maxarea", area, "no limit", -1.0F, address(Quantity::Area))) {
        context.applyCommand(setRegionArea(document, index, area.value_or(0.0)), "Limit area of region");
    }
    ui::rowTooltip(context, "Maximum area of an element in this region");
    regionSizeRow(context, index);
    regionElementsRow(context, marker.tag);
    mappedRows(context, marker);
    borderButton(context);
    ImGui::SameLine(0, context.px(6));
    if (ui::button(context, "inspector/delete", "Delete")) {
        context.actions.run("edit.delete", context);
    }
}

void inspectFace(Shell &context, Vec2 place) {
    inspectorHeading(context, "Face without a region");
    areaRow(context, place, regionColour(1));
    borderButton(context);
    ImGui::SameLine(0, context.px(6));
    if (ui::button(context, "inspector/mark", "Make it a region")) {
        markRegion(context, place, tagOfNewRegion(*context.document.current()));
        return;
    }
    ui::tooltip(context, "A region has a name, and can have an element size and elements of its own");
}

} // namespace forefront
