#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// A task of the user, for which the window shows suitable panels, tools and layers.
enum class WorkspaceKind : std::uint8_t { Draw, Size, Mesh, Step, Judge };

inline constexpr std::array kWorkspaceKinds{WorkspaceKind::Draw, WorkspaceKind::Size, WorkspaceKind::Mesh,
                                            WorkspaceKind::Step, WorkspaceKind::Judge};

/// What a workspace shows before the user changes it; ids.
struct WorkspacePreset {
    const char *word; ///< in the settings and in the names of widgets and actions: "draw"
    const char *name; ///< on the screen: "Draw"
    const char *about;
    std::span<const std::string_view> panels; ///< of the column, from top to bottom
    std::span<const std::string_view> folded; ///< those of them that are folded
    std::span<const std::string_view> tools;  ///< of the strip
    std::span<const std::string_view> layers; ///< those that are visible
};
const WorkspacePreset &presetOf(WorkspaceKind kind);

/// Returns the workspace with this word, or std::nullopt.
std::optional<WorkspaceKind> workspaceOf(std::string_view word);

/// What the user changed in a workspace, by id. Everything else is as in its preset.
struct WorkspaceChanges {
    std::map<std::string, bool> panels; ///< shown in the column or not
    std::map<std::string, bool> folded;
    std::map<std::string, bool> layers; ///< visible or not
    std::vector<std::string> order;     ///< of all panels of the column; empty: as in the preset

    friend bool operator==(const WorkspaceChanges &, const WorkspaceChanges &) = default;
};

} // namespace forefront
