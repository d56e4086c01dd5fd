#include "ui/editor/apply_settings.hpp"

#include "ui/dialogs/file_commands.hpp"
#include "ui/parts/shell.hpp"
#include "ui/parts/shown_panels.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>

namespace forefront {

namespace {

std::string wholeName(const std::filesystem::path &file) {
    std::error_code ignored;
    return std::filesystem::absolute(file, ignored).lexically_normal().string();
}

} // namespace

void applySettings(Shell &context) {
    const Settings &settings = context.settings;
    showWorkspaceLayers(context);
    context.view.panels = settings.panels;
    context.snapping = settings.snapping;
    for (const auto &[action, keys] : settings.keys) {
        context.actions.rebind(action, parseShortcut(keys));
    }
}

Settings settingsToSave(const Shell &context) {
    Settings settings = context.settings;
    const std::optional<OpenLesson> &lesson = context.lessons.open;
    settings.workspace = lesson ? lesson->workspaceBefore : settings.workspace;
    settings.workspaces[static_cast<std::size_t>(settings.workspace)].layers =
        changedLayers(settings.workspace, lesson ? lesson->layersBefore : chosenLayers(context));
    settings.panels = lesson ? lesson->panelsBefore : context.view.panels;
    settings.snapping = context.snapping;
    settings.openFiles.clear();
    for (std::size_t tab = 0; tab < context.tabs.size(); ++tab) {
        if (const std::filesystem::path file = captionOf(context, tab).path; !file.empty()) {
            settings.openFiles.push_back(wholeName(file));
        }
    }
    for (const std::filesystem::path &file : context.tabs.waiting) { // such as while a dialog is open at the start
        if (!opensInBackground(file)) {
            settings.openFiles.push_back(wholeName(file));
            settings.lastFile = settings.openFiles.back(); // the last one is to be shown
        }
    }
    return settings;
}

} // namespace forefront
