#pragma once

#include "ui/workspace/view/workspaces.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

class Panel;
class Tool;
struct Shell;

/// Shows the panels, tools and layers of a workspace, with what the user changed there.
void chooseWorkspace(Shell &context, WorkspaceKind kind);

/// Returns the changes in the workspace that is shown.
WorkspaceChanges &changesOf(Shell &context);
const WorkspaceChanges &changesOf(const Shell &context);

/// Returns the panel with this id, or null.
Panel *findPanel(const Shell &context, std::string_view id);
/// Returns the panels of the column from top to bottom: first those that something has called, see showPanel().
std::vector<Panel *> columnPanels(const Shell &context);
/// Returns true if a panel belongs to the workspace that is shown, or is pinned to all of them.
bool belongsHere(const Shell &context, std::string_view panel);
/// Returns true if the user folded a panel in this workspace, or it is folded at first.
bool isFolded(const Shell &context, std::string_view panel);
void setFolded(Shell &context, std::string_view panel, bool folded);
/// Adds a panel to the workspace that is shown or removes it.
void setShown(Shell &context, std::string_view panel, bool shown);
/// Moves a panel of the column in front of another one.
void movePanel(Shell &context, std::string_view panel, std::string_view before);
/// Shows a panel wherever it has its place, unfolded. One that belongs to another workspace comes to the top of the
/// column until another workspace is chosen.
void showPanel(Shell &context, std::string_view id);

/// Returns true if the strip of the workspace that is shown has a button for the tool; it always has one for the
/// active tool.
bool isInStrip(const Shell &context, const Tool &tool);

/// Shows the layers of the workspace that is shown as the user left them.
void showWorkspaceLayers(Shell &context);
/// Shows the layers of the preset of the workspace that is shown.
void showPresetLayers(Shell &context);
/// Returns the layers whose visibility differs from the preset of a workspace. `visible` is by id.
std::map<std::string, bool> changedLayers(WorkspaceKind kind, const std::map<std::string, bool> &visible);
/// Returns which layers the user has chosen to see, by id: not those that showMeshColours() shows.
std::map<std::string, bool> chosenLayers(const Shell &context);

} // namespace forefront
