#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "ui/background/background_task.hpp"
#include "ui/dialogs/file_dialog.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

namespace forefront {

struct Shell;

/// Reads a file on another thread, and returns how to use what was read on the thread of the window.
using FileReader = std::function<Result<BackgroundTask::Finish>(const Progress &)>;

/// Runs `read` as the background task of the shell, in place of an earlier task. Faults go to `outcome`; if that is
/// null, they are logged.
void readInBackground(Shell &context, const std::filesystem::path &file, const std::shared_ptr<FileOutcome> &outcome,
                      FileReader read);

/// Returns true, and reports it, if another document was opened since `loads` was taken from the document store, so
/// that a file that was read meanwhile must not replace it. If its document is in another tab, that is shown first.
bool replacedWhileReading(Shell &context, const std::filesystem::path &file, std::uint64_t loads);

} // namespace forefront
