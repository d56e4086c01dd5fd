#include "ui/parts/shown_panels.hpp"

#include "ui/parts/shell.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

namespace forefront {

namespace {

bool contains(std::span<const std::string_view> ids, std::string_view id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// Keeps the layers shown as the user's choice for the workspace. Those of a lesson are not the user's.
void rememberLayers(Shell &context) {
    if (!context.lessons.open) {
        changesOf(context).layers = changedLayers(context.settings.workspace, chosenLayers(context));
    }
}

/// Returns the ids of all panels of the column in the order of the workspace that is shown.
std::vector<std::string> orderHere(const Shell &context) {
    std::vector<std::string> order = changesOf(context).order;
    const auto add = [&order](std::string_view id) {
        if (std::find(order.begin(), order.end(), id) == order.end()) {
            order.emplace_back(id);
        }
    };
    for (const std::string_view id : presetOf(context.settings.workspace).panels) {
        add(id);
    }
    for (const auto &panel : context.panels) {
        if (panel->place() == PanelPlace::Column) {
            add(panel->id());
        }
    }
    return order;
}

bool isCalled(const Shell &context, std::string_view panel) {
    return std::find(context.called.begin(), context.called.end(), panel) != context.called.end();
}

/// Returns true if the page of the open lesson outlines a widget.
bool isOutlined(const Shell &context, const std::string &widget) {
    if (!context.lessons.open) {
        return false;
    }
    const auto &highlights = context.lessons.open->now().highlights;
    return std::any_of(highlights.begin(), highlights.end(),
                       [&widget](const LessonHighlight &highlight) { return highlight.widget == widget; });
}

} // namespace

WorkspaceChanges &changesOf(Shell &context) {
    return context.settings.workspaces[static_cast<std::size_t>(context.settings.workspace)];
}

const WorkspaceChanges &changesOf(const Shell &context) {
    return context.settings.workspaces[static_cast<std::size_t>(context.settings.workspace)];
}

void showWorkspaceLayers(Shell &context) {
    const WorkspacePreset &preset = presetOf(context.settings.workspace);
    const auto &changed = changesOf(context).layers;
    for (LayerSlot &slot : context.layers) {
        const auto known = changed.find(slot.layer->id());
        slot.visible = known != changed.end() ? known->second : contains(preset.layers, slot.layer->id());
    }
}

void chooseWorkspace(Shell &context, WorkspaceKind kind) {
    if (kind == context.settings.workspace) {
        return;
    }
    rememberLayers(context);
    context.called.clear();
    context.animate();
    context.settings.workspace = kind;
    context.probe.follow(0); // forgets the parts, which were looked at there
    const Tool &tool = context.tools.current();
    if (!contains(presetOf(kind).tools, tool.id()) && !isOutlined(context, std::string("tool/") + tool.id())) {
        context.tools.choose("select", context); // a tool that is not in sight would surprise
    }
    const bool coloured = context.coloursBefore.has_value();
    context.coloursBefore.reset();
    showWorkspaceLayers(context);
    if (coloured) {
        showMeshColours(context);
    }
}

Panel *findPanel(const Shell &context, std::string_view id) {
    for (const auto &panel : context.panels) {
        if (panel->id() == id) {
            return panel.get();
        }
    }
    return nullptr;
}

bool belongsHere(const Shell &context, std::string_view panel) {
    const std::string id(panel);
    if (context.settings.pinned.contains(id)) {
        return true;
    }
    const auto &changed = changesOf(context).panels;
    const auto known = changed.find(id);
    return known != changed.end() ? known->second : contains(presetOf(context.settings.workspace).panels, panel);
}

std::vector<Panel *> columnPanels(const Shell &context) {
    std::vector<Panel *> panels;
    for (const std::string &id : context.called) {
        if (!belongsHere(context, id)) {
            panels.push_back(findPanel(context, id));
        }
    }
    for (const std::string &id : orderHere(context)) {
        if (Panel *const panel = findPanel(context, id); panel != nullptr && belongsHere(context, id)) {
            panels.push_back(panel);
        }
    }
    return panels;
}

bool isFolded(const Shell &context, std::string_view panel) {
    const auto &changed = changesOf(context).folded;
    const auto known = changed.find(std::string(panel));
    if (known != changed.end()) {
        return known->second;
    }
    return contains(presetOf(context.settings.workspace).folded, panel) && !isCalled(context, panel);
}

void setFolded(Shell &context, std::string_view panel, bool folded) {
    changesOf(context).folded[std::string(panel)] = folded;
    context.animate();
}

void setShown(Shell &context, std::string_view panel, bool shown) {
    const std::string id(panel);
    if (!shown) {
        std::erase(context.called, id);
        context.settings.pinned.erase(id);
    }
    changesOf(context).panels[id] = shown;
    context.animate();
}

void movePanel(Shell &context, std::string_view panel, std::string_view before) {
    std::vector<std::string> order;
    for (const std::string &id : orderHere(context)) {
        if (id == before) {
            order.emplace_back(panel);
        }
        if (id != panel) {
            order.push_back(id);
        }
    }
    changesOf(context).order = std::move(order);
    context.animate();
}

void showPanel(Shell &context, std::string_view id) {
    Panel *const panel = findPanel(context, id);
    if (panel == nullptr) {
        return;
    }
    context.animate();
    switch (panel->place()) {
    case PanelPlace::Canvas:
        context.plates.layers = true;
        return;
    case PanelPlace::Drawer:
        context.plates.log = true;
        return;
    case PanelPlace::Menu:
        context.plates.history = true;
        return;
    case PanelPlace::Below:
        chooseWorkspace(context, WorkspaceKind::Judge);
        setFolded(context, id, false);
        return;
    case PanelPlace::Column:
        break;
    }
    context.view.panels = true;
    context.plates.column = true;
    if (!isCalled(context, id)) {
        context.called.emplace_back(id);
    }
    const auto folded = changesOf(context).folded.find(std::string(id));
    if (folded != changesOf(context).folded.end() && folded->second) {
        folded->second = false;
    }
    context.revealedPanel = id;
}

bool isInStrip(const Shell &context, const Tool &tool) {
    return contains(presetOf(context.settings.workspace).tools, tool.id()) || &tool == &context.tools.current() ||
           isOutlined(context, std::string("tool/") + tool.id());
}

void showPresetLayers(Shell &context) {
    changesOf(context).layers.clear();
    context.coloursBefore.reset();
    showWorkspaceLayers(context);
    context.animate();
}

std::map<std::string, bool> changedLayers(WorkspaceKind kind, const std::map<std::string, bool> &visible) {
    std::map<std::string, bool> changed;
    for (const auto &[id, shown] : visible) {
        if (shown != contains(presetOf(kind).layers, id)) {
            changed[id] = shown;
        }
    }
    return changed;
}

std::map<std::string, bool> chosenLayers(const Shell &context) {
    std::map<std::string, bool> visible;
    for (const LayerSlot &slot : context.layers) {
        const bool coloured = context.coloursBefore && slot.layer->coloursByValue();
        visible[slot.layer->id()] = coloured ? slot.layer->id() == *context.coloursBefore : slot.visible;
    }
    return visible;
}

} // namespace forefront
