#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace forefront {

/// Command-line options of the editor.
struct EditorArguments {
    std::optional<std::filesystem::path> file;      ///< project or domain file to open; none: the start page
    std::vector<std::filesystem::path> others;      ///< files to open in further tabs
    bool judge = false;                             ///< open `file` as a mesh to inspect
    std::optional<int> frames;                      ///< close after this many frames (for tests)
    std::optional<std::filesystem::path> stateFile; ///< write the state of each frame there (for tests)

    friend bool operator==(const EditorArguments &, const EditorArguments &) = default;
};

/// Exit code of the editor if no window can be opened (no display, no OpenGL 3.3, the editor's program is missing).
inline constexpr int kNoWindow = 4;

/// Returns the words of the command line by which `forefront` starts the editor's program, after its name.
std::vector<std::string> editorWords(const EditorArguments &arguments);

/// Reads what editorWords returned; empty if the words are anything else.
std::optional<EditorArguments> editorArgumentsOf(std::span<const std::string> words);

/// Runs the editor until its window is closed and returns the exit code of the program.
int runEditor(const EditorArguments &arguments);

} // namespace forefront
