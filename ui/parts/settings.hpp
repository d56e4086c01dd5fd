#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/mesher/options.hpp"
#include "ui/platform/platform.hpp"
#include "ui/style/theme.hpp"
#include "ui/workspace/view/snapping.hpp"
#include "ui/workspace/view/workspaces.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace forefront {

/// The part of the plane in view when a file was last closed.
struct SavedView {
    Vec2 centre;
    double zoom = 1.0; ///< pixels per unit
    friend bool operator==(const SavedView &, const SavedView &) = default;
};

/// How far a lesson has been read.
struct LessonProgress {
    std::size_t page = 0;
    std::uint64_t seed = 1; ///< of its random numbers, until there are answers, which have their own
    friend bool operator==(const LessonProgress &, const LessonProgress &) = default;
};

/// The settings that the program saves between runs.
struct Settings {
    ThemeKind theme = ThemeKind::Dark;
    double scale = 1.0;                ///< interface scale set by the user, 0.75 to 3; multiplies the monitor's scale
    std::optional<double> panelWidth;  ///< width of the right column, design pixels; not set: by the window's
    bool hints = true;                 ///< show the hint strip
    bool rulers = false;               ///< show rulers along the canvas
    bool reduceMotion = false;         ///< changes are shown at once
    bool live = true;                  ///< mesh after every edit
    double liveBudget = 25'000.0;      ///< see RunControl::liveBudget
    std::optional<WindowPlace> window; ///< position when the program last ended
    std::vector<std::string> recentFiles;
    std::vector<std::string> recentMeshes;  ///< files opened or compared as meshes, the last one first
    bool reopens = true;                    ///< open the last projects when the program starts without a file
    std::string lastFile;                   ///< absolute path of the last project opened or saved; empty: none
    std::vector<std::string> openFiles;     ///< absolute paths of the projects in the tabs, from left to right
    std::map<std::string, SavedView> views; ///< last view of each recent file
    bool panels = true;                     ///< show the right column
    WorkspaceKind workspace = WorkspaceKind::Draw;
    std::array<WorkspaceChanges, kWorkspaceKinds.size()> workspaces; ///< by kind
    std::set<std::string> pinned;                                    ///< ids of panels shown in all workspaces
    Snapping snapping;
    Method newMethod = Method::Fast; ///< of new documents, like the next
    ImproveLevel newImprove = ImproveLevel::Default;
    std::optional<double> newSize, newGradation; ///< see SpacingSpec
    std::optional<double> newPerTurn, newAcross; ///< elements along a full turn and across gaps
    std::string exportFormat;                    ///< id of the format to which a mesh was exported last; empty: none
    std::map<std::string, std::string> folders;  ///< last used in a file dialog, by its id
    /// Shortcuts that the user changed, by id of the action; an empty text means none.
    std::map<std::string, std::string> keys;
    std::map<std::string, LessonProgress> lessons; ///< by id of the lesson
    std::map<std::string, int> toolUses;           ///< by id of the tool, as far as hints depend on it
    friend bool operator==(const Settings &, const Settings &) = default;
};

/// Range of Settings::panelWidth.
inline constexpr double kMinPanelWidth = 240.0, kMaxPanelWidth = 640.0;
/// Range of Settings::liveBudget.
inline constexpr double kMinLiveBudget = 1e3, kMaxLiveBudget = 1e6;
/// Range of Snapping::reach.
inline constexpr double kMinSnapReach = 3.0, kMaxSnapReach = 30.0;
/// Range of Snapping::angleStep.
inline constexpr double kMinAngleStep = 1.0, kMaxAngleStep = 90.0;

/// Loads the settings, or the defaults if the file is missing or damaged (with a warning in `faults`, if not null).
/// Numbers are clamped to their ranges.
Settings loadSettings(const std::filesystem::path &file, Diagnostics *faults = nullptr);
void saveSettings(const std::filesystem::path &file, const Settings &settings);

} // namespace forefront
