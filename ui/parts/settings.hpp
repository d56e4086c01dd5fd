#pragma once

#include "core/base/diagnostic.hpp"
#include "ui/platform/platform.hpp"
#include "ui/style/theme.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// What the program remembers between runs.
struct Settings {
    ThemeKind theme = ThemeKind::Dark;
    double scale = 1.0;                ///< the user's slider, 0.75 to 3, on top of the monitor's scale
    double panelWidth = 304.0;         ///< of the right column, design pixels
    double tabsHeight = 196.0;         ///< of the tabs at its bottom
    bool hints = true;                 ///< the strip for the first run
    std::optional<WindowPlace> window; ///< when the program last ended
    std::vector<std::string> recentFiles;
    friend bool operator==(const Settings &, const Settings &) = default;
};

/// Defaults where the file is missing or spoilt (then with a warning in `faults`, if not null); numbers are brought
/// into range.
Settings loadSettings(const std::filesystem::path &file, Diagnostics *faults = nullptr);
void saveSettings(const std::filesystem::path &file, const Settings &settings);

} // namespace forefront
