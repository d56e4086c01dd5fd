#pragma once

#include <filesystem>

namespace forefront {

class Editor;

/// Writes the editor's state atomically as JSON, for tests of the real window to wait on: frame, settled, run, tool,
/// dialog, document revision, widget rectangles.
void writeStateFile(const std::filesystem::path &file, Editor &editor);

} // namespace forefront
