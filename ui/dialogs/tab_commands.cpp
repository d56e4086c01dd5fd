#include "ui/dialogs/tab_commands.hpp"

#include "core/files/files.hpp"
#include "ui/dialogs/file_commands.hpp"
#include "ui/dialogs/file_dialog.hpp"
#include "ui/parts/shell.hpp"

#include <imgui.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

namespace forefront {

namespace {

std::filesystem::path wholePath(const std::filesystem::path &file) {
    std::error_code ignored;
    return std::filesystem::absolute(file, ignored).lexically_normal();
}

std::optional<std::size_t> tabOf(const Shell &context, const std::filesystem::path &file) {
    for (std::size_t tab = 0; tab < context.tabs.size(); ++tab) {
        const std::filesystem::path path = captionOf(context, tab).path;
        if (!path.empty() && wholePath(path) == wholePath(file)) {
            return tab;
        }
    }
    return std::nullopt;
}

std::optional<std::size_t> tabWith(const Shell &context, std::uint64_t loads) {
    for (std::size_t tab = 0; tab < context.tabs.size(); ++tab) {
        const auto &left = context.tabs.at(tab).left;
        if ((left ? left->document.loads : context.document.loads()) == loads) {
            return tab;
        }
    }
    return std::nullopt;
}

/// Opens a mesh, drawing or map in a tab once another thread has read it.
void openForeignInTab(Shell &context, const std::filesystem::path &file, const std::shared_ptr<FileOutcome> &outcome) {
    readForeign(context, file, outcome, [file](Shell &c, const auto &opened, const auto &notes) {
        freshTab(c);
        showOpened(c, *opened, *notes, file);
    });
}

/// Opens a project in a tab, or shows the tab where it is open. Returns the faults of a file that cannot be read.
Diagnostics openProjectInTab(Shell &context, const std::filesystem::path &file) {
    if (showTabOf(context, file)) {
        return {};
    }
    ImportNotes notes;
    const Result<StampedDocument> read = readStamped(file, &notes);
    if (!read) {
        return read.faults();
    }
    freshTab(context);
    showOpened(context, *read, notes, file);
    return {};
}

/// Closes the tab with this id without asking.
void closeAgreed(Shell &context, std::uint64_t id) {
    for (std::size_t tab = 0; tab < context.tabs.size(); ++tab) {
        if (context.tabs.at(tab).id == id) {
            context.tabs.close(tab, context);
            return;
        }
    }
}

/// Replaces the document of the only tab by an empty one, without asking.
void closeLast(Shell &context) {
    const std::filesystem::path &file = context.document.path();
    if (!file.empty() && wholePath(file) == context.settings.lastFile) {
        context.settings.lastFile.clear(); // a document that was closed does not come back at the next start
    }
    beginDocument(context);
}

/// Asks about each tab from `tab` on, then runs `then`.
void askFrom(Shell &context, std::size_t tab, const std::function<void(Shell &)> &then) {
    for (; tab < context.tabs.size(); ++tab) {
        if (tab == context.tabs.active() || captionOf(context, tab).dirty) {
            if (captionOf(context, tab).dirty) {
                showTab(context, tab); // the user sees what is asked about
            }
            afterUnsaved(context, [tab, then](Shell &c) { askFrom(c, tab + 1, then); });
            return;
        }
    }
    then(context);
}

void stepTab(Shell &context, std::size_t step) {
    showTab(context, (context.tabs.active() + step) % context.tabs.size());
}

bool severalTabs(const Shell &context) {
    return context.tabs.size() > 1;
}

/// Returns an entry for each tab; the one shown is marked.
std::vector<MenuEntry> tabEntries(const Shell &context) {
    std::vector<MenuEntry> entries;
    for (std::size_t tab = 0; tab < context.tabs.size(); ++tab) {
        const TabCaption caption = captionOf(context, tab);
        std::string detail = caption.dirty ? "not saved" : caption.path.parent_path().string();
        entries.push_back({.id = std::to_string(tab),
                           .title = (tab == context.tabs.active() ? "\xe2\x80\xa2 " : "") + caption.title,
                           .detail = std::move(detail),
                           .run = [tab](Shell &c) { showTab(c, tab); }});
    }
    return entries;
}

} // namespace

void newTab(Shell &context) {
    rememberView(context);
    context.tabs.open(context);
    beginDocument(context);
}

void freshTab(Shell &context) {
    finishInput(context);
    if (!isBlank(context)) {
        rememberView(context);
        context.tabs.open(context);
    }
}

void openInTab(Shell &context) {
    FileRequest request;
    request.id = "opentab";
    request.title = "Open in new tab";
    request.action = "Open";
    request.filters = drawingFilters();
    request.folder = startFolder(context);
    request.reads = [](Shell &c, const std::filesystem::path &file) {
        auto outcome = opensInBackground(file) ? std::make_shared<FileOutcome>() : nullptr;
        if (outcome) {
            openForeignInTab(c, file, outcome);
        }
        return outcome;
    };
    request.chosen = [](Shell &c, const std::filesystem::path &file, const FileFilter &) {
        return openProjectInTab(c, file);
    };
    context.dialogs.open(std::make_unique<FileDialog>(std::move(request)));
}

void openInTab(Shell &context, const std::filesystem::path &file) {
    if (opensInBackground(file)) {
        openForeignInTab(context, file, nullptr);
    } else {
        context.log.add(openProjectInTab(context, file));
    }
}

void showTab(Shell &context, std::size_t tab) {
    if (tab != context.tabs.active()) {
        rememberView(context);
        context.tabs.show(tab, context);
    }
}

bool showTabOf(Shell &context, const std::filesystem::path &file) {
    const std::optional<std::size_t> tab = tabOf(context, file);
    if (tab) {
        showTab(context, *tab);
    }
    return tab.has_value();
}

bool showOtherTabOf(Shell &context, const std::filesystem::path &file) {
    const std::filesystem::path &shown = context.document.path();
    return (shown.empty() || wholePath(shown) != wholePath(file)) && showTabOf(context, file);
}

bool showTabWith(Shell &context, std::uint64_t loads) {
    const std::optional<std::size_t> tab = tabWith(context, loads);
    if (tab) {
        showTab(context, *tab);
    }
    return tab.has_value();
}

std::optional<std::size_t> tabOfLesson(const Shell &context) {
    return tabWith(context, context.lessons.drawingLoaded);
}

void closeTab(Shell &context, std::size_t tab) {
    if (context.lessons.open && tabOfLesson(context) == tab) {
        showTab(context, tab);
        context.actions.run("lesson.close", context);
    }
    if (!severalTabs(context)) {
        afterUnsaved(context, closeLast);
        return;
    }
    const std::uint64_t id = context.tabs.at(tab).id;
    if (tab == context.tabs.active() || captionOf(context, tab).dirty) {
        showTab(context, tab);
        afterUnsaved(context, [id](Shell &c) {
            rememberView(c);
            closeAgreed(c, id);
        });
    } else {
        closeAgreed(context, id);
    }
}

void afterAllUnsaved(Shell &context, const std::function<void(Shell &)> &then) {
    askFrom(context, 0, then);
}

const std::filesystem::path *nextInTab(const Shell &context) {
    const bool opens = !context.tabs.waiting.empty() && !context.task.busy() && !context.task.ready() &&
                       !context.dialogs.any() && !ImGui::IsAnyMouseDown();
    return opens ? &context.tabs.waiting.front() : nullptr;
}

void followTabs(Shell &context) {
    context.tabs.limitMemory(context);
    if (nextInTab(context) == nullptr) {
        return;
    }
    const std::filesystem::path next = std::move(context.tabs.waiting.front());
    context.tabs.waiting.pop_front();
    openInTab(context, next);
    context.animate();
}

void addTabActions(ActionRegistry &actions) {
    actions.add({.id = "file.newTab",
                 .menu = "File",
                 .title = "New tab",
                 .shortcuts = {{'T', kControl}},
                 .run = newTab,
                 .separatorBefore = true});
    actions.add({.id = "file.openInTab", .menu = "File", .title = "Open in new tab\xe2\x80\xa6", .run = [](Shell &c) {
                     openInTab(c);
                 }});
    actions.add({.id = "file.tabs",
                 .menu = "File",
                 .title = "Tabs",
                 .run = [](Shell &c) { stepTab(c, 1); },
                 .enabled = severalTabs,
                 .entries = [](const Shell &c) { return tabEntries(c); }});
    actions.add({.id = "file.nextTab",
                 .menu = "File",
                 .title = "Next tab",
                 .shortcuts = {{key::kPageDown, kControl}},
                 .run = [](Shell &c) { stepTab(c, 1); },
                 .enabled = severalTabs});
    actions.add({.id = "file.previousTab",
                 .menu = "File",
                 .title = "Previous tab",
                 .shortcuts = {{key::kPageUp, kControl}},
                 .run = [](Shell &c) { stepTab(c, c.tabs.size() - 1); },
                 .enabled = severalTabs});
    actions.add(
        {.id = "file.closeTab", .menu = "File", .title = "Close", .shortcuts = {{'W', kControl}}, .run = [](Shell &c) {
             closeTab(c, c.tabs.active());
         }});
}

} // namespace forefront
