#pragma once

#include "app/window/editor_entry.hpp"

namespace forefront {

/// Becomes the editor's program, which lies beside this one or in the folder of internal programs: only it loads the
/// libraries of the window, so the batch commands start quickly. Returns kNoWindow, with a message on stderr, if the
/// program is not found or cannot be started.
int startEditor(const EditorArguments &arguments);

} // namespace forefront
