#include "ui/shell/tool_actions.hpp"

#include "core/engine/spacing/parts/paint/paint.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/make_tools.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace forefront {
namespace {

bool brushIsChosen(const Shell &context) {
    const std::string_view tool = context.tools.current().id();
    return tool == "brush" || tool == "eraser";
}

/// Adds a command that the brush handles while it is chosen.
void addBrushCommand(ActionRegistry &actions, const char *word, const char *title, Shortcut shortcut) {
    actions.add({.id = std::string("brush.") + word,
                 .menu = "",
                 .title = title,
                 .shortcuts = {shortcut},
                 .run = [word](Shell &c) { c.tools.current().command(word, c); },
                 .enabled = brushIsChosen,
                 .repeats = true});
}

void addBrushActions(ActionRegistry &actions) {
    addBrushCommand(actions, "smaller", "Brush: smaller radius", {key::kLeftBracket, kNoModifiers});
    addBrushCommand(actions, "larger", "Brush: larger radius", {key::kRightBracket, kNoModifiers});
    addBrushCommand(actions, "sizeDown", "Brush: paint smaller elements", {key::kLeftBracket, kShift});
    addBrushCommand(actions, "sizeUp", "Brush: paint larger elements", {key::kRightBracket, kShift});
    for (const DabMode mode : valuesOf<DabMode>()) {
        const std::string word(wordOf(mode));
        actions.add({.id = "brush.mode." + word, .menu = "", .title = "Brush mode: " + word, .run = [word](Shell &c) {
                         c.tools.choose("brush", c);
                         c.tools.current().command(word, c);
                     }});
    }
}

void addSnapActions(ActionRegistry &actions) {
    actions.add({.id = "snap.drawing",
                 .menu = "",
                 .title = "Snap to drawing",
                 .run = [](Shell &c) { c.snapping.toDrawing = !c.snapping.toDrawing; },
                 .checked = [](const Shell &c) { return c.snapping.toDrawing; }});
    actions.add({.id = "snap.grid",
                 .menu = "",
                 .title = "Snap to grid",
                 .run = [](Shell &c) { c.snapping.toGrid = !c.snapping.toGrid; },
                 .checked = [](const Shell &c) { return c.snapping.toGrid; }});
    actions.add({.id = "snap.guides",
                 .menu = "",
                 .title = "Snap to guides",
                 .run = [](Shell &c) { c.snapping.toGuides = !c.snapping.toGuides; },
                 .checked = [](const Shell &c) { return c.snapping.toGuides; }});
    actions.add({.id = "snap.relations",
                 .menu = "",
                 .title = "Find relations to other lines and nodes",
                 .run = [](Shell &c) { c.snapping.infers = !c.snapping.infers; },
                 .checked = [](const Shell &c) { return c.snapping.infers; }});
    actions.add({.id = "snap.constraints",
                 .menu = "",
                 .title = "Add sketch constraints while drawing",
                 .run = [](Shell &c) { c.snapping.addsConstraints = !c.snapping.addsConstraints; },
                 .checked = [](const Shell &c) { return c.snapping.addsConstraints; }});
}

} // namespace

void shell::addToolActions(ActionRegistry &actions) {
    for (const auto &tool : makeTools()) {
        actions.add({.id = std::string("tool.") + tool->id(),
                     .menu = "",
                     .title = std::string("Tool: ") + tool->name(),
                     .shortcuts = {{tool->key(), kNoModifiers}},
                     .run = [id = std::string(tool->id())](Shell &c) { c.tools.choose(id, c); }});
    }
    addBrushActions(actions);
    addSnapActions(actions);
}

} // namespace forefront
