#include "ui/dialogs/group_actions.hpp"

#include "core/drawing/shapes/groups.hpp"
#include "ui/parts/shell.hpp"

#include <algorithm>

namespace forefront {

namespace {

void group(Shell &context) {
    if (context.applyCommand(groupShapes(*context.document.current(), context.selection.shapes), "Group")) {
        completeGroups(*context.document.current(), context.selection);
    }
}

void ungroup(Shell &context) {
    context.applyCommand(ungroupShapes(*context.document.current(), context.selection.shapes), "Ungroup");
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
