#pragma once

#include <filesystem>
#include <optional>

namespace forefront {

/// Command-line options of the editor.
struct EditorArguments {
    std::optional<std::filesystem::path> file;      ///< project or domain file to open; none: the sample
    bool judge = false;                             ///< open `file` as a mesh to inspect
    std::optional<int> frames;                      ///< close after this many frames (for tests)
    std::optional<std::filesystem::path> stateFile; ///< write the state of each frame there (for tests)
};

/// Exit code of runEditor if no window can be opened (no display, no OpenGL 3.3).
inline constexpr int kNoWindow = 4;

/// Runs the editor until its window is closed and returns the exit code of the program.
int runEditor(const EditorArguments &arguments);

} // namespace forefront
