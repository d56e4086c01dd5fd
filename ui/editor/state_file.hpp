#pragma once

#include <filesystem>

namespace forefront {

class Editor;

/// Writes the state that tests of the real window wait for, as JSON and atomically: frame, settled, run, tool, dialog,
/// document revision, widget rectangles.
void writeStateFile(const std::filesystem::path &file, Editor &editor);

} // namespace forefront
