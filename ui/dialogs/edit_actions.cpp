#include "ui/app/app_context.hpp"

namespace forefront {

void addEditActions(ActionRegistry &actions) {
    constexpr Modifiers kControl{Modifiers::kControl};
    constexpr Modifiers kControlShift{Modifiers::kControl | Modifiers::kShift};
    actions.add({.id = "file.quit", .menu = "File", .title = "Quit", .shortcuts = {{'Q', kControl}},
                 .run = [](AppContext &c) { c.quit = true; }, .separatorBefore = true});
    actions.add({.id = "edit.undo", .menu = "Edit", .title = "Undo", .shortcuts = {{'Z', kControl}},
                 .run = [](AppContext &c) {
                     if (!c.tools.current().undo(c)) {
                         c.document().undo();
                     }
                 },
                 .dynamic = [](const AppContext &c) { return "Undo " + c.document().undoLabel(); }, .repeats = true});
    actions.add({.id = "edit.redo", .menu = "Edit", .title = "Redo",
                 .shortcuts = {{'Z', kControlShift}, {'Y', kControl}},
                 .run = [](AppContext &c) {
                     if (!c.tools.current().redo(c)) {
                         c.document().redo();
                     }
                 },
                 .dynamic = [](const AppContext &c) { return "Redo " + c.document().redoLabel(); }, .repeats = true});
}

} // namespace forefront
