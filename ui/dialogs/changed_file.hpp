#pragma once

#include "core/files/source/file_stamp.hpp"

#include <functional>

namespace forefront {

class ActionRegistry;
struct Shell;

/// Returns true if the file of the document no longer holds what was last read from it or saved to it; `now`: its
/// stamp.
bool changedOnDisk(const Shell &context, const FileStamp &now);
/// Asks whether to overwrite a file that another program has changed or deleted, to read it again or to save the
/// document elsewhere. Runs `then`, if not empty, once the document is saved.
void askAboutChange(Shell &context, const FileStamp &now, std::function<void(Shell &)> then);
/// Reads the file of the document again. What was there before can be brought back by undo.
void reloadDocument(Shell &context);
/// Logs it when another program changes or deletes the file of the document. Called once per frame.
void followFile(Shell &context);

} // namespace forefront
