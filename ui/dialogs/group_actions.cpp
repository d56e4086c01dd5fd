#include "ui/dialogs/group_actions.hpp"

#include "core/drawing/shapes/groups.hpp"
#include "core/engine/base/number_text.hpp"
#include "ui/parts/shell.hpp"

#include <algorithm>
#include <cstddef>

namespace forefront {

namespace {

void group(Shell &context) {
    if (context.applyCommand(groupShapes(*context.document.current(), context.selection.shapes), "Group")) {
        completeGroups(*context.document.current(), context.selection);
        context.log.announce("Grouped " + countText(context.selection.shapes.size(), "shape") +
                             ": a click selects all of them, with Ctrl one");
    }
}

void ungroup(Shell &context) {
    const std::size_t shapes = context.selection.shapes.size();
    if (context.applyCommand(ungroupShapes(*context.document.current(), context.selection.shapes), "Ungroup")) {
        context.log.announce("Ungrouped " + countText(shapes, "shape"));
    }
}

bool hasGroup(const Shell &context) {
    const auto &shapes = context.document.current()->shapes;
    return std::any_of(shapes.begin(), shapes.end(), [&](const auto &shape) {
        return shape->group != 0 && context.selection.shapes.contains(shape->id);
    });
}

} // namespace

void addGroupActions(ActionRegistry &actions) {
    actions.add({.id = "shape.group",
                 .menu = "Shape",
                 .title = "Group",
                 .shortcuts = {{'G', kControl}},
                 .run = group,
                 .enabled = [](const Shell &c) { return c.selection.shapes.size() > 1; },
                 .separatorBefore = true});
    actions.add({.id = "shape.ungroup",
                 .menu = "Shape",
                 .title = "Ungroup",
                 .shortcuts = {{'G', kControlShift}},
                 .run = ungroup,
                 .enabled = hasGroup});
}

} // namespace forefront
