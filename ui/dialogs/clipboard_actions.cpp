#include "ui/dialogs/clipboard_actions.hpp"

#include "core/drawing/commands/insert_document.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing_files/clipboard/clipboard.hpp"
#include "ui/dialogs/region_actions.hpp"
#include "ui/parts/shell.hpp"
#include "ui/workspace/edit_state.hpp"

#include <optional>
#include <utility>

namespace forefront {
namespace {

void copy(Shell &context) {
    const std::optional<Document> faces = drawingOfFaces(context);
    context.platform.copyDrawing(faces ? clipboardText(*faces)
                                       : clipboardText(*context.document.current(), context.selection));
}

/// Inserts the drawing on the clipboard where it was copied from, or beside what is already there.
void paste(Shell &context) {
    ImportNotes notes;
    const Result<Document> drawing = readClipboard(context.platform.copiedDrawing(), &notes);
    if (!drawing) {
        context.log.add(drawing.faults());
        return;
    }
    const Document &document = *context.document.current();
    Insertion insertion;
    const double step = 2.0 * EditState::gridStep(context);
    Result<Document> next = insertCopied(document, *drawing, {step, -step}, &insertion);
    const bool first = document.shapes.empty();
    if (context.applyCommand(std::move(next), "Paste")) {
        context.tools.choose("select", context);
        context.selection = std::move(insertion.added);
        context.log.add(notes.diagnostics());
        context.log.add(insertion.notes);
        if (first) {
            context.actions.run("view.fit", context);
            return;
        }
        const Box2 pasted = boundsOf(*context.document.current(), context.selection);
        if (!pasted.overlaps(context.view.camera.visible())) {
            context.view.reveal(pasted);
        }
    }
}

/// Copies what the tool shows, such as a measured length, otherwise the selection.
void copyAny(Shell &context) {
    if (const std::string text = context.tools.current().copyText(context); !text.empty()) {
        context.platform.setClipboard(text);
        context.log.announce("Copied " + text);
    } else {
        copy(context);
    }
}

} // namespace

bool canCopy(const Shell &context) {
    const Selection &selection = context.selection;
    return !selection.shapes.empty() || !selection.sources.empty() || !selection.markers.empty() ||
           selection.onlyFaces();
}

void addClipboardActions(ActionRegistry &actions) {
    actions.add({.id = "edit.cut",
                 .menu = "Edit",
                 .title = "Cut",
                 .shortcuts = {{'X', kControl}},
                 .run =
                     [](Shell &c) {
                         copy(c);
                         if (deleteRegions(c, "Cut")) {
                             return;
                         }
                         c.selection.nodes.clear(); // nodes and segments on their own are not copied
                         c.selection.segments.clear();
                         c.applyCommand(deleteSelection(*c.document.current(), c.selection), "Cut");
                         c.selection.clear();
                     },
                 .enabled = canCopy,
                 .separatorBefore = true});
    actions.add({.id = "edit.copy",
                 .menu = "Edit",
                 .title = "Copy",
                 .shortcuts = {{'C', kControl}},
                 .run = copyAny,
                 .enabled = [](const Shell &c) { return canCopy(c) || !c.tools.current().copyText(c).empty(); },
                 .dynamic =
                     [](const Shell &c) {
                         return std::string(c.tools.current().copyText(c).empty() ? "Copy" : "Copy values");
                     }});
    actions.add({.id = "edit.paste", .menu = "Edit", .title = "Paste", .shortcuts = {{'V', kControl}}, .run = paste});
}

} // namespace forefront
