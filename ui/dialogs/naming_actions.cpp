#include "ui/dialogs/naming_actions.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/dialogs/shape_actions.hpp"
#include "ui/parts/shell.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/workspace/current_faces.hpp"
#include "ui/workspace/mark_region.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace forefront {
namespace {

/// Returns the row of the Shapes panel that F2 renames: the last one clicked, while the panel is shown.
const std::optional<NamedThing> &rowToName(const Shell &context) {
    static const std::optional<NamedThing> kNone;
    const Naming &naming = context.naming;
    const bool shown = naming.rowFrame >= ImGui::GetFrameCount() - 1;
    return shown && naming.row && naming.row->existsIn(*context.document.current()) ? naming.row : kNone;
}

/// Opens the field where the context menu was opened on the canvas, otherwise at what is selected.
void nameOnCanvas(Shell &context, NamedThing thing) {
    const Document &document = *context.document.current();
    const Camera &camera = context.view.camera;
    Pixel at = camera.toPixel(boundsOf(document, context.selection).centre());
    if (context.menu.running && camera.viewport.contains(context.menu.at)) {
        at = context.menu.at;
    }
    std::optional<NamedThing> other = otherThing(document, context.selection, thing);
    context.naming.openOnCanvas(std::move(thing), at, context.document);
    context.naming.other = std::move(other);
    context.animate();
}

/// Returns true if a face is selected that is no region, and nothing else.
bool onlyUnmarkedFace(const Selection &selection) {
    return selection.size() == 1 && selection.faces.size() == 1;
}

void rename(Shell &context) {
    const bool unmarked = !rowToName(context) && onlyUnmarkedFace(context.selection);
    if (unmarked &&
        !markRegion(context, *context.selection.faces.begin(), tagOfNewRegion(*context.document.current()))) {
        return;
    }
    if (const std::optional<NamedThing> &row = rowToName(context)) {
        context.naming.openInPanel(*row);
        context.animate();
    } else if (std::optional<NamedThing> thing = namedThing(*context.document.current(), context.selection)) {
        nameOnCanvas(context, *std::move(thing));
    }
}

void setTag(Shell &context) {
    if (std::optional<NamedThing> part = boundaryPartOf(*context.document.current(), context.selection)) {
        nameOnCanvas(context, *std::move(part));
    }
}

/// Returns the field of the inspector with the element size of the selection; empty if it has none.
std::string sizeField(const Shell &context) {
    const Selection &selection = context.selection;
    const Document &document = *context.document.current();
    if (!selection.nodes.empty() && selection.nodes.size() == selection.size()) {
        return "inspector/nodesize";
    }
    if (selection.shapes.size() + selection.segments.size() == selection.size()) {
        const Shape *const only = selection.size() == 1 && !selection.shapes.empty()
                                      ? findShape(document, *selection.shapes.begin())
                                      : nullptr;
        return selection.empty()                               ? ""
               : only != nullptr && taggedSegments(*only) == 0 ? "inspector/nodesize"
                                                               : "inspector/segmentsize";
    }
    if (!selection.markers.empty() && selection.markers.size() == selection.size()) {
        return "inspector/regionsize";
    }
    return selection.size() == 1 && !selection.sources.empty() ? "inspector/size" : "";
}

void enterSize(Shell &context) {
    showPanel(context, "inspector");
    context.widgets.fields.request(sizeField(context));
    context.animate();
}

/// Shows the selection and some of what is around it.
void zoomToSelection(Shell &context) {
    const Document &document = *context.document.current();
    Box2 box = boundsOf(document, context.selection);
    const FacesMeant meant = facesMeant(context);
    for (const std::uint32_t face : meant.faces) {
        box.add(meant.map->faces()[face].box);
    }
    const double least = 0.01 * boundsOf(document).diagonal();
    box = box.grown(std::max(0.15 * box.diagonal(), least > 0.0 ? least : 1.0));
    context.view.fit(box);
    context.view.fitted.reset(); // resizing the window keeps the place, not the selection
    context.animate();
}

} // namespace

void addNamingActions(ActionRegistry &actions) {
    actions.add({.id = "edit.rename",
                 .menu = "Edit",
                 .title = "Rename\xe2\x80\xa6",
                 .shortcuts = {{key::kF1 + 1, kNoModifiers}},
                 .run = rename,
                 .enabled =
                     [](const Shell &c) {
                         return rowToName(c) || onlyUnmarkedFace(c.selection) ||
                                namedThing(*c.document.current(), c.selection).has_value();
                     },
                 .separatorBefore = true});
    actions.add(
        {.id = "edit.setTag",
         .menu = "Edit",
         .title = "Set boundary tag\xe2\x80\xa6",
         .shortcuts = {{'T', kShift}},
         .run = setTag,
         .enabled = [](const Shell &c) { return !c.selection.shapes.empty() || !c.selection.segments.empty(); }});
    actions.add({.id = "edit.setSize",
                 .menu = "Edit",
                 .title = "Element size\xe2\x80\xa6",
                 .run = enterSize,
                 .enabled = [](const Shell &c) { return !sizeField(c).empty(); }});
    actions.add({.id = "view.zoomSelection",
                 .menu = "View",
                 .title = "Zoom to selection",
                 .shortcuts = {{'F', kShift}},
                 .run = zoomToSelection,
                 .enabled = hasSelection});
}

} // namespace forefront
