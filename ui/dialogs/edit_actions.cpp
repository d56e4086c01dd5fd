#include "core/drawing/arrangement/repair/repair.hpp"
#include "core/drawing/commands/junction_constraints.hpp"
#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/commands/shared_segments.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/dialogs/changed_file.hpp"
#include "ui/dialogs/clipboard_actions.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/gallery_dialog.hpp"
#include "ui/dialogs/naming_actions.hpp"
#include "ui/dialogs/open_mesh.hpp"
#include "ui/dialogs/preferences_dialog.hpp"
#include "ui/dialogs/region_actions.hpp"
#include "ui/dialogs/repair_dialog.hpp"
#include "ui/dialogs/shape_actions.hpp"
#include "ui/dialogs/tab_commands.hpp"
#include "ui/dialogs/unit_dialog.hpp"
#include "ui/parts/shell.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/joined_command.hpp"
#include "ui/workspace/picture_view.hpp"

#include <algorithm>
#include <cstdint>
#include <set>

namespace forefront {
namespace {

bool hasShapes(const Shell &context) {
    return !context.document.current()->shapes.empty();
}

/// Opens a recent file; removes it from the list if it no longer exists.
void openRecent(Shell &context, const std::filesystem::path &file) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) {
        std::erase(context.settings.recentFiles, file.string());
    }
    openDocument(context, file);
}

/// Returns an entry for each recent file, with its folder in grey, and one that clears the list.
std::vector<MenuEntry> recentFileEntries(const Shell &context) {
    std::vector<MenuEntry> entries;
    for (const std::string &name : context.settings.recentFiles) {
        const std::filesystem::path file = name;
        entries.push_back({.id = std::to_string(entries.size()),
                           .title = file.filename().string(),
                           .detail = file.parent_path().string(),
                           .run = [file](Shell &c) { openRecent(c, file); }});
    }
    if (!entries.empty()) {
        entries.push_back(
            {.id = "clear", .title = "Clear list", .run = [](Shell &c) { c.settings.recentFiles.clear(); }});
    }
    return entries;
}

/// Adds the actions that open files and documents.
void addOpenActions(ActionRegistry &actions) {
    actions.add({.id = "file.new", .menu = "File", .title = "New", .shortcuts = {{'N', kControl}}, .run = newDocument});
    actions.add({.id = "file.open",
                 .menu = "File",
                 .title = "Open\xe2\x80\xa6",
                 .shortcuts = {{'O', kControl}},
                 .run = [](Shell &c) { openDocument(c); }});
    actions.add({.id = "file.openMesh", .menu = "File", .title = "Open mesh\xe2\x80\xa6", .run = [](Shell &c) {
                     openMesh(c);
                 }});
    actions.add({.id = "file.compareMesh",
                 .menu = "File",
                 .title = "Compare with mesh\xe2\x80\xa6",
                 .run = [](Shell &c) { compareMesh(c); },
                 .enabled = [](const Shell &c) { return c.run.now().mesh != nullptr; }});
    actions.add({.id = "file.recent",
                 .menu = "File",
                 .title = "Open recent",
                 .run = [](Shell &c) { openDocument(c, c.settings.recentFiles.front()); },
                 .enabled = [](const Shell &c) { return !c.settings.recentFiles.empty(); },
                 .dynamic =
                     [](const Shell &c) {
                         return c.settings.recentFiles.empty()
                                    ? std::string("Open recent")
                                    : "Open " +
                                          std::filesystem::path(c.settings.recentFiles.front()).filename().string();
                     },
                 .entries = [](const Shell &c) { return recentFileEntries(c); }});
    actions.add({.id = "file.samples", .menu = "File", .title = "Samples\xe2\x80\xa6", .run = [](Shell &c) {
                     c.dialogs.open(std::make_unique<GalleryDialog>(c));
                 }});
}

/// Adds the actions that save, import and export. addFileMenuEnd() adds the rest of the menu.
void addFileActions(ActionRegistry &actions) {
    actions.add({.id = "file.save",
                 .menu = "File",
                 .title = "Save",
                 .shortcuts = {{'S', kControl}},
                 .run = [](Shell &c) { saveDocument(c); },
                 .separatorBefore = true});
    actions.add({.id = "file.saveAs",
                 .menu = "File",
                 .title = "Save as\xe2\x80\xa6",
                 .shortcuts = {{'S', kControlShift}},
                 .run = [](Shell &c) { saveDocumentAs(c); }});
    actions.add(
        {.id = "file.reload", .menu = "File", .title = "Reload", .run = reloadDocument, .enabled = [](const Shell &c) {
             return !c.document.path().empty();
         }});
    actions.add({.id = "file.import",
                 .menu = "File",
                 .title = "Import drawing\xe2\x80\xa6",
                 .shortcuts = {{'I', kControl}},
                 .run = importDrawing,
                 .separatorBefore = true});
    actions.add(
        {.id = "file.importSpacing", .menu = "File", .title = "Import spacing\xe2\x80\xa6", .run = importSpacing});
    actions.add({.id = "file.addRaster", .menu = "File", .title = "Add raster\xe2\x80\xa6", .run = addRaster});
    actions.add(
        {.id = "file.addPicture", .menu = "File", .title = "Add background picture\xe2\x80\xa6", .run = [](Shell &c) {
             addPicture(c);
         }});
    actions.add({.id = "file.openRules",
                 .menu = "File",
                 .title = "Open rules\xe2\x80\xa6",
                 .run = openRules,
                 .separatorBefore = true});
    actions.add({.id = "file.saveRules", .menu = "File", .title = "Save rules\xe2\x80\xa6", .run = saveRules});
    actions.add({.id = "file.export",
                 .menu = "File",
                 .title = "Export mesh\xe2\x80\xa6",
                 .shortcuts = {{'E', kControl}},
                 .run = [](Shell &c) { exportMesh(c); },
                 .enabled = hasShapes,
                 .separatorBefore = true});
    actions.add({.id = "file.exportPicture",
                 .menu = "File",
                 .title = "Export picture of the mesh\xe2\x80\xa6",
                 .run = [](Shell &c) { exportMesh(c, "svg"); },
                 .enabled = hasShapes});
    actions.add({.id = "file.exportMoment",
                 .menu = "File",
                 .title = "Export picture of the moment\xe2\x80\xa6",
                 .run = exportMoment,
                 .enabled = hasShapes});
    actions.add({.id = "file.exportFilm",
                 .menu = "File",
                 .title = "Export film\xe2\x80\xa6",
                 .run = exportFilm,
                 .enabled = hasShapes});
}

/// Returns the tool whose input undo concerns: the active one, or one that keeps a path which it dropped; null if none.
Tool *undoingTool(const Shell &context) {
    if (!context.tools.current().undoLabel(context).empty()) {
        return &context.tools.current();
    }
    const auto &tools = context.tools.tools;
    const auto found =
        std::find_if(tools.begin(), tools.end(), [&](const auto &tool) { return !tool->undoLabel(context).empty(); });
    return found != tools.end() ? found->get() : nullptr;
}

/// Returns the step that undo would undo: in the unfinished input of a tool first, then in the document.
std::string undoLabel(const Shell &context) {
    const Tool *const tool = undoingTool(context);
    return tool == nullptr ? context.document.undoLabel() : tool->undoLabel(context);
}

std::string redoLabel(const Shell &context) {
    const std::string ofTool = context.tools.current().redoLabel(context);
    return ofTool.empty() ? context.document.redoLabel() : ofTool;
}

std::string titleWith(const char *verb, const std::string &what) {
    return what.empty() ? verb : std::string(verb) + ' ' + what;
}

/// Shows the drawing where a step has left it out of view or as good as a dot, such as that of an import of a map.
void keepDrawingInView(Shell &context) {
    constexpr double kDot = 0.02; // of the extent in view
    const Box2 drawing = boundsOf(*context.document.current()), seen = context.view.camera.visible();
    if (!drawing.empty() && (!drawing.overlaps(seen) || drawing.diagonal() < kDot * seen.diagonal())) {
        context.actions.run("view.fit", context);
    }
}

void travel(Shell &context, bool (DocumentStore::*step)()) {
    const std::shared_ptr<const Document> before = context.document.current();
    (context.document.*step)();
    keepPictureInView(context, *before);
    keepDrawingInView(context);
    context.selection.faces.clear(); // their places belong to the drawing before the step
}

void undo(Shell &context) {
    if (Tool *const tool = undoingTool(context)) {
        context.tools.choose(tool->id(), context); // the path is continued with its tool
        static_cast<void>(tool->undo(context));
    } else {
        travel(context, &DocumentStore::undo);
    }
}

void addHistoryActions(ActionRegistry &actions) {
    actions.add({.id = "edit.undo",
                 .menu = "Edit",
                 .title = "Undo",
                 .shortcuts = {{'Z', kControl}},
                 .run = undo,
                 .enabled = [](const Shell &c) { return !undoLabel(c).empty(); },
                 .dynamic = [](const Shell &c) { return titleWith("Undo", undoLabel(c)); },
                 .repeats = true});
    actions.add({.id = "edit.redo",
                 .menu = "Edit",
                 .title = "Redo",
                 .shortcuts = {{'Z', kControlShift}, {'Y', kControl}},
                 .run =
                     [](Shell &c) {
                         if (!c.tools.current().redo(c)) {
                             travel(c, &DocumentStore::redo);
                         }
                     },
                 .enabled = [](const Shell &c) { return !redoLabel(c).empty(); },
                 .dynamic = [](const Shell &c) { return titleWith("Redo", redoLabel(c)); },
                 .repeats = true});
    actions.add({.id = "edit.history",
                 .menu = "Edit",
                 .title = "History",
                 .run =
                     [](Shell &c) {
                         c.plates.history = !c.plates.history;
                         c.animate();
                     },
                 .checked = [](const Shell &c) { return c.plates.history; }});
}

bool hasPathNode(const Shell &context) {
    const Document &document = *context.document.current();
    return std::any_of(context.selection.nodes.begin(), context.selection.nodes.end(), [&](NodeRef node) {
        const Shape *const shape = findShape(document, node.shape);
        return shape != nullptr && isPath(*shape);
    });
}

bool hasPath(const Shell &context) {
    const Document &document = *context.document.current();
    return std::any_of(context.selection.shapes.begin(), context.selection.shapes.end(), [&](std::uint32_t id) {
        const Shape *const shape = findShape(document, id);
        return shape != nullptr && isPath(*shape);
    });
}

/// Returns the selected nodes, or all nodes of the selected paths if no node is selected.
std::set<NodeRef> nodesMeant(const Document &document, const Selection &selection) {
    std::set<NodeRef> nodes = selection.nodes;
    for (const std::uint32_t id : selection.nodes.empty() ? selection.shapes : std::set<std::uint32_t>()) {
        const Shape *const shape = findShape(document, id);
        const std::size_t count = shape != nullptr && isPath(*shape) ? shape->nodes.size() : 0;
        for (std::size_t k = 0; k < count; ++k) {
            nodes.insert({id, static_cast<std::uint32_t>(k)});
        }
    }
    return nodes;
}

bool hasPathSegment(const Shell &context) {
    const Document &document = *context.document.current();
    return std::any_of(context.selection.segments.begin(), context.selection.segments.end(), [&](SegmentRef segment) {
        const Shape *const shape = findShape(document, segment.shape);
        return shape != nullptr && isPath(*shape);
    });
}

/// Makes nodes smooth, and tangent by constraints where these bind the segments beside them, as one step.
void makeSmooth(Shell &context, NodeKind kind, const char *title) {
    const std::shared_ptr<const Document> before = context.document.current();
    context.document.endStroke();
    if (context.applyCommand(setNodeKind(*before, nodesMeant(*before, context.selection), kind), title, title)) {
        context.document.apply(constrainJunctions(*before, *context.document.current()), title, title);
    }
    context.document.endStroke();
}

/// Returns true if nodes of paths are selected, or paths as a whole.
bool hasPathNodes(const Shell &context) {
    return hasPathNode(context) || (context.selection.nodes.empty() && hasPath(context));
}

/// Adds the commands on nodes and segments of paths, with the keys of Inkscape.
void addPathActions(ActionRegistry &actions) {
    const auto add = [&](const char *id, const char *title, int key, bool (*enabled)(const Shell &), bool first,
                         Result<Document> (*command)(const Document &, const Selection &)) {
        actions.add(
            {.id = id,
             .menu = "Edit",
             .title = title,
             .shortcuts = {{key, Modifiers{Modifiers::kShift}}},
             .run = [title, command](Shell &c) { c.applyCommand(command(*c.document.current(), c.selection), title); },
             .enabled = enabled,
             .separatorBefore = first});
    };
    const auto addSmooth = [&](const char *id, const char *title, int key, NodeKind kind) {
        actions.add({.id = id,
                     .menu = "Edit",
                     .title = title,
                     .shortcuts = {{key, Modifiers{Modifiers::kShift}}},
                     .run = [title, kind](Shell &c) { makeSmooth(c, kind, title); },
                     .enabled = hasPathNodes});
    };
    add("path.corner", "Corner node", 'C', hasPathNodes, true,
        [](const Document &d, const Selection &s) { return setNodeKind(d, nodesMeant(d, s), NodeKind::Corner); });
    addSmooth("path.smooth", "Smooth node", 'S', NodeKind::Smooth);
    addSmooth("path.symmetric", "Symmetric node", 'Y', NodeKind::Symmetric);
    add("path.line", "Segment to line", 'L', hasPathSegment, false,
        [](const Document &d, const Selection &s) { return setCurved(d, s.segments, false); });
    add("path.curve", "Segment to curve", 'U', hasPathSegment, false,
        [](const Document &d, const Selection &s) { return setCurved(d, s.segments, true); });
    add(
        "path.split", "Split path at node", 'B',
        [](const Shell &c) { return c.selection.nodes.size() == 1 && hasPathNode(c); }, false,
        [](const Document &d, const Selection &s) { return splitPath(d, *s.nodes.begin()); });
    add(
        "path.join", "Join ends", 'J', [](const Shell &c) { return c.selection.nodes.size() == 2 && hasPathNode(c); },
        false, [](const Document &d, const Selection &s) { return joinEnds(d, *s.nodes.begin(), *s.nodes.rbegin()); });
}

void addSelectionActions(ActionRegistry &actions) {
    addClipboardActions(actions);
    actions.add({.id = "edit.delete",
                 .menu = "Edit",
                 .title = "Delete",
                 .shortcuts = {{key::kDelete, kNoModifiers}},
                 .run =
                     [](Shell &c) {
                         if (deleteRegions(c, "Delete")) {
                             return;
                         }
                         const Document &document = *c.document.current();
                         const bool shapes = c.selection.nodes.empty(); // joints are those of nodes
                         if (shapes ? c.applyCommand(deleteSelection(document, c.selection), "Delete")
                                    : applyJoined(c, deleteUnlessJoined(JointIndex(document), c.selection), "Delete")) {
                             c.selection.clear();
                         }
                     },
                 .enabled = hasSelection});
    actions.add(
        {.id = "edit.duplicate",
         .menu = "Edit",
         .title = "Duplicate",
         .shortcuts = {{'D', kControl}},
         .run =
             [](Shell &c) {
                 if (duplicateFaces(c)) {
                     return;
                 }
                 Selection copies;
                 const double step = 2.0 * EditState::gridStep(c);
                 if (c.applyCommand(duplicateSelection(*c.document.current(), c.selection, {step, -step}, &copies),
                                    "Duplicate")) {
                     c.selection = std::move(copies);
                 }
             },
         .enabled = canCopy});
    actions.add({.id = "edit.selectAll",
                 .menu = "Edit",
                 .title = "Select all",
                 .shortcuts = {{'A', kControl}},
                 .run = [](Shell &c) {
                     c.selection = selectAll(*c.document.current());
                     c.tools.choose("select", c);
                 }});
    actions.add({.id = "edit.toPath",
                 .menu = "Edit",
                 .title = "Convert to path",
                 .run =
                     [](Shell &c) {
                         c.applyCommand(convertToPaths(*c.document.current(), c.selection.shapes), "Convert to path");
                     },
                 .enabled = [](const Shell &c) { return !c.selection.shapes.empty(); },
                 .separatorBefore = true});
    addPathActions(actions);
    actions.add({.id = "edit.repair",
                 .menu = "Edit",
                 .title = "Repair drawing",
                 .run = [](Shell &c) { repairDrawing(c); },
                 .enabled = [](const Shell &c) { return anyRepairable(c.preview->faults); }});
    actions.add({.id = "edit.clearPaint",
                 .menu = "Edit",
                 .title = "Clear paint",
                 .run = [](Shell &c) { c.document.apply(setPaint(*c.document.current(), {}), "Clear paint"); },
                 .enabled = [](const Shell &c) { return !c.document.current()->spacing.paint.tiles.empty(); }});
}

} // namespace

void addEditActions(ActionRegistry &actions) {
    addOpenActions(actions);
    addTabActions(actions);
    addFileActions(actions);
    addHistoryActions(actions);
    addSelectionActions(actions);
    addNamingActions(actions);
    addRegionActions(actions);
    addShapeActions(actions);
    addUnitAction(actions);
    actions.add({.id = "edit.preferences",
                 .menu = "Edit",
                 .title = "Preferences\xe2\x80\xa6",
                 .shortcuts = {{key::kComma, kControl}},
                 .run = [](Shell &c) { c.dialogs.open(std::make_unique<PreferencesDialog>()); },
                 .separatorBefore = true});
}

} // namespace forefront
