#include "ui/editor/editor.hpp"

#include "app/window/editor_entry.hpp"
#include "app/window/icon.hpp"
#include "core/drawing/recovery/recovery_journal.hpp"
#include "ui/platform/glfw_platform.hpp"

#include <cstdio>
#include <cstdlib>

namespace forefront {

namespace {

/// Returns $XDG_CONFIG_HOME/forefront or ~/.config/forefront; empty without a home directory.
std::filesystem::path settingsFolder() {
    const auto variable = [](const char *name) {
        const char *value = std::getenv(name);
        return std::filesystem::path(value != nullptr ? value : "");
    };
    if (const auto config = variable("XDG_CONFIG_HOME"); !config.empty()) {
        return config / "forefront";
    }
    const auto home = variable("HOME");
    return home.empty() ? home : home / ".config/forefront";
}

} // namespace

int runEditor(const EditorArguments &arguments) {
    const std::filesystem::path folder = settingsFolder();
    const Settings settings = folder.empty() ? Settings() : loadSettings(folder / "settings.json");
    std::string fault;
    const std::unique_ptr<GlfwPlatform> platform =
        GlfwPlatform::create({1440, 900}, "Forefront", settings.window, fault);
    if (!platform) {
        std::fprintf(stderr, "forefront: cannot open a window: %s\n", fault.c_str());
        return kNoWindow;
    }
    platform->setIcon({64, 64}, makeIcon(64));
    EditorSetup setup;
    setup.settingsFolder = folder;
    setup.stateFolder = stateFolder();
    setup.file = arguments.file.value_or(std::filesystem::path());
    setup.others = arguments.others;
    setup.judge = arguments.judge;
    setup.sample = false;
    setup.startPage = true;
    setup.reopens = true;
    setup.stateFile = arguments.stateFile.value_or(std::filesystem::path());
    Editor editor(*platform, setup);
    while (editor.running()) {
        platform->poll(editor.input(), editor.sleepSeconds());
        if (editor.needsFrame()) {
            editor.frame();
        }
        if (arguments.frames && editor.frames() >= static_cast<std::uint64_t>(*arguments.frames)) {
            break;
        }
    }
    return 0;
}

} // namespace forefront
