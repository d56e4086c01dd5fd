#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

namespace forefront {

class ActionRegistry;
struct Shell;

// The commands on the tabs of a window; see DocumentTabs. They report faults in the log.

/// Opens a tab with an empty drawing.
void newTab(Shell &context);
/// Makes room for a document that is to be opened beside the others: a new tab, unless the document shown is as good as
/// none.
void freshTab(Shell &context);
/// Asks for a file and opens it in a tab of its own.
void openInTab(Shell &context);
/// Opens a file in a tab of its own, or shows the tab where it is open as a project.
void openInTab(Shell &context, const std::filesystem::path &file);
/// Shows a tab.
void showTab(Shell &context, std::size_t tab);
/// Shows the tab whose document has this file. Returns false if there is none.
bool showTabOf(Shell &context, const std::filesystem::path &file);
/// Does the same, but returns false if it is the document shown that has the file.
bool showOtherTabOf(Shell &context, const std::filesystem::path &file);
/// Shows the tab with the document of this DocumentStore::loads(). Returns false if there is none.
bool showTabWith(Shell &context, std::uint64_t loads);
/// Returns the tab with the last drawing that a lesson brought; none: it is not open any more.
std::optional<std::size_t> tabOfLesson(const Shell &context);
/// Closes a tab after asking whether to save its unsaved changes. The last one becomes an empty drawing. A lesson that
/// has its drawing there ends, and the drawing of the user comes back to be asked about.
void closeTab(Shell &context, std::size_t tab);
/// Runs `then` after asking whether to save the unsaved changes of each tab in turn.
void afterAllUnsaved(Shell &context, const std::function<void(Shell &)> &then);
/// Returns the file that followTabs() would open now; null: none waits, or none can be opened yet.
const std::filesystem::path *nextInTab(const Shell &context);
/// Opens the files that wait for it, and limits the memory of tabs in the background. Called once per frame.
void followTabs(Shell &context);
/// Registers the actions of tabs.
void addTabActions(ActionRegistry &actions);

} // namespace forefront
