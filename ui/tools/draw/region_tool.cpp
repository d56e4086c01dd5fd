#include "ui/tools/draw/region_tool.hpp"

#include "core/drawing/commands/region_fill.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/common/region_menu.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/current_faces.hpp"
#include "ui/workspace/mark_region.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

const char *RegionTool::icon() const {
    return icon::kRegion;
}

void RegionTool::deactivate(Shell &context) {
    DrawingTool::deactivate(context);
    context.view.facePlace.reset();
}

void RegionTool::forget(Shell &context) {
    DrawingTool::forget(context);
    context.view.facePlace.reset();
    tag_.reset();
}

void RegionTool::pointed(Shell &context) {
    context.view.facePlace = over_ ? std::optional(pointer_.at) : std::nullopt;
}

std::int32_t RegionTool::tagOfNext(const Shell &context) const {
    return tag_ ? *tag_ : tagOfNewRegion(*context.document.current());
}

std::optional<std::uint32_t> RegionTool::selectable(const MappedFace &face) const {
    const bool selects = face.marker != kNoIndex && (!tag_ || *tag_ == face.tag);
    return selects ? std::optional(face.marker) : std::nullopt;
}

void RegionTool::place(Vec2 at, Shell &context) {
    const std::shared_ptr<const Document> document = context.document.current();
    const std::shared_ptr<const FaceMap> faces = currentFaces(context);
    const std::uint32_t face = faces->faceAt(at);
    if (const auto marker = face != kNoIndex ? selectable(faces->faces()[face]) : std::nullopt) {
        context.selection.clear();
        context.selection.markers.insert(*marker);
        return;
    }
    const std::int32_t tag = tagOfNext(context);
    Result<Document> next = fillRegion(*document, at, tag);
    if (next && !next->regionMarkers.empty()) {
        const auto index = static_cast<std::uint32_t>(next->regionMarkers.size() - 1);
        const PlaceFormula formula = formulaOf(at);
        for (const auto &[axis, text] : {std::pair(Quantity::X, formula.x), std::pair(Quantity::Y, formula.y)}) {
            next = usesNames(text) ? setFormula(*std::move(next), {NumberOwner::ofRegion(index), axis}, text)
                                   : std::move(next);
        }
    }
    if (context.applyCommand(std::move(next), "Fill " + regionName(document->regionNames, tag))) {
        context.selection.clear();
        const auto count = context.document.current()->regionMarkers.size();
        context.selection.markers.insert(static_cast<std::uint32_t>(count - 1));
    }
}

std::vector<ContextGroup> RegionTool::menu(Shell &context, Vec2 place) {
    ContextGroup group = regionMenu(context, place, true, tagOfNext(context));
    if (group.empty()) {
        return {};
    }
    std::erase_if(group, [](const ContextItem &item) { return item.own.id == "region/rename"; }); // as the next one
    group.push_back(commandOf("nameFace", "Name this face\xe2\x80\xa6", [this, place](Shell &c) {
        const std::optional<std::int32_t> chosen = std::exchange(tag_, std::nullopt); // the face keeps its region
        this->place(place, c);
        tag_ = chosen;
        c.actions.run("edit.rename", c);
    }));
    return {std::move(group)};
}

/// Returns the name of the region that a face has or would get, and its area.
std::string RegionTool::labelOf(const MappedFace &face, const Shell &context) const {
    const std::map<std::int32_t, std::string> &names = context.document.current()->regionNames;
    const std::string area = "   area " + ui::number(face.area, 4);
    if (selectable(face)) {
        return regionName(names, face.tag) + area;
    }
    return (tag_ ? "make " : "new ") + regionName(names, tagOfNext(context)) + area;
}

void RegionTool::drawSketch(CanvasPainter &painter, Shell &context) {
    const std::shared_ptr<const FaceMap> &faces = context.preview->faces;
    const std::uint32_t face = over_ && faces ? faces->faceAt(pointer_.at) : kNoIndex;
    if (face != kNoIndex) {
        painter.label(pointer_.at, {14.0, 10.0}, labelOf(faces->faces()[face], context), context.theme.text,
                      fade(context.theme.popup, 0.9), context.fonts.small);
    }
}

std::string RegionTool::statusText(const Shell &context) const {
    if (tag_) {
        return "Click a face to make it part of " + regionName(context.document.current()->regionNames, *tag_) +
               ". New region: make each face a new region again";
    }
    return "Click a face to make it a region, or to select its region; faces without a region belong to region 1";
}

void RegionTool::drawOptions(Shell &context, ui::Flow &flow) {
    const std::shared_ptr<const Document> document = context.document.current();
    const std::int32_t next = tagOfNext(context);
    flow.item("tag");
    flow.label("Region");
    double value = next;
    if (ui::inputNumber(context, "options/region/tag", value, 44.0F) &&
        ui::checkTag(context, "options/region/tag", value)) {
        tag_ = static_cast<std::int32_t>(value);
    }
    ui::tooltip(context, "Tag of the region that a click gives a face");
    flow.item("name");
    std::string name = regionName(document->regionNames, next);
    if (ui::inputName(context, "options/region/name", name, "name", 140.0F, true) &&
        context.applyCommand(setRegionName(*document, next, name), "Name region")) {
        tag_ = next;
    }
    flow.item("new");
    if (ui::button(context, "options/region/new", "New region")) {
        tag_.reset();
    }
    ui::tooltip(context, "Gives each face that is clicked a region of its own");
}

} // namespace forefront
