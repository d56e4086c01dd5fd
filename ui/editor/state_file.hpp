#pragma once

#include <filesystem>

namespace forefront {

class Editor;

/// Writes the state that a test of the real window waits for: frame, whether the picture is settled, run, tool, dialog,
/// document revision, widget rectangles. JSON, atomic.
void writeStateFile(const std::filesystem::path &file, Editor &editor);

} // namespace forefront
