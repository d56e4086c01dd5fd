#pragma once

#include "core/base/diagnostic.hpp"
#include "ui/platform/platform.hpp"
#include "ui/style/theme.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// The settings that the program saves between runs.
struct Settings {
    ThemeKind theme = ThemeKind::Dark;
    double scale = 1.0;                ///< interface scale set by the user, 0.75 to 3; multiplies the monitor's scale
    double panelWidth = 304.0;         ///< width of the right column, design pixels
    double tabsHeight = 196.0;         ///< height of the tabs at its bottom, design pixels
    bool hints = true;                 ///< show the hint strip
    bool live = true;                  ///< mesh after every edit
    double liveBudget = 25'000.0;      ///< see RunControl::liveBudget
    std::optional<WindowPlace> window; ///< position when the program last ended
    std::vector<std::string> recentFiles;
    friend bool operator==(const Settings &, const Settings &) = default;
};

/// Range of Settings::liveBudget.
inline constexpr double kMinLiveBudget = 1e3, kMaxLiveBudget = 1e6;

/// Loads the settings, or the defaults if the file is missing or damaged (with a warning in `faults`, if not null).
/// Numbers are clamped to their ranges.
Settings loadSettings(const std::filesystem::path &file, Diagnostics *faults = nullptr);
void saveSettings(const std::filesystem::path &file, const Settings &settings);

} // namespace forefront
