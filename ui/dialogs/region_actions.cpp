#include "ui/dialogs/region_actions.hpp"

#include "core/drawing/commands/copy_faces.hpp"
#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/picking/pick_index.hpp"
#include "core/drawing/picking/selected_faces.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/engine/base/number_text.hpp"
#include "ui/parts/shell.hpp"
#include "ui/workspace/current_faces.hpp"
#include "ui/workspace/edit_state.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

namespace forefront {
namespace {

/// Says what is left of regions that were deleted.
std::string remainsOf(const Document &before, const std::set<std::uint32_t> &markers) {
    const std::string unmarked = regionName(before.regionNames, 1);
    if (markers.size() > 1) {
        return countText(markers.size(), "region") + " deleted; their borders stay, and their faces belong to " +
               unmarked;
    }
    const std::string name = regionName(before.regionNames, before.regionMarkers[*markers.begin()].tag);
    return "Region " + name + " deleted; its border stays, and its face belongs to " + unmarked;
}

/// Selects the lines around the selected faces.
void selectBorder(Shell &context) {
    const FacesMeant meant = facesMeant(context);
    if (!meant.map) {
        context.log.add(error("no-face", "the region marker lies in no face", "move it into a face of the domain"));
        return;
    }
    const PickIndex index(context.document.current());
    FaceBorder border = borderOf(index, *meant.map, meant.faces);
    const bool complete = border.locked.empty() && border.hiddenEdges == 0;
    context.selection = std::move(border.lines);
    context.selection.prune(*context.document.current());
    if (!complete) {
        context.log.announce("Hidden and locked lines of the border are not selected");
    }
    context.tools.choose("select", context);
    context.animate();
}

} // namespace

std::optional<Document> drawingOfFaces(const Shell &context) {
    const FacesMeant meant = facesMeant(context);
    return meant.map ? std::optional(copyFaces(*context.document.current(), *meant.map, meant.faces)) : std::nullopt;
}

bool deleteRegions(Shell &context, const char *verb) {
    if (!context.selection.onlyFaces()) {
        return false;
    }
    const std::shared_ptr<const Document> before = context.document.current();
    const std::set<std::uint32_t> markers = context.selection.markers;
    if (markers.empty()) {
        context.log.add(error("unmarked-face", "cannot delete a face that is no region",
                              "select its border to delete lines, which joins it with its neighbours"));
        return true;
    }
    if (context.applyCommand(deleteSelection(*before, context.selection),
                             std::string(verb) + (markers.size() == 1 ? " region" : " regions"))) {
        context.selection.clear();
        context.log.announce(remainsOf(*before, markers));
    }
    return true;
}

bool duplicateFaces(Shell &context) {
    const std::optional<Document> drawing = drawingOfFaces(context);
    if (!drawing) {
        return false;
    }
    const double step = 2.0 * EditState::gridStep(context);
    const Result<Document> moved = moveSelection(*drawing, everythingIn(*drawing), {step, -step});
    Insertion insertion;
    if (context.applyCommand(moved ? insertCopied(*context.document.current(), *moved, {step, -step}, &insertion)
                                   : moved,
                             "Duplicate")) {
        context.selection = std::move(insertion.added);
    }
    return true;
}

void addRegionActions(ActionRegistry &actions) {
    actions.add({.id = "edit.selectBorder",
                 .menu = "Edit",
                 .title = "Select border of region",
                 .run = selectBorder,
                 .enabled = [](const Shell &c) { return c.selection.onlyFaces(); }});
}

} // namespace forefront
