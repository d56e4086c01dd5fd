#pragma once

#include <filesystem>
#include <string>

namespace forefront {

/// Creates and locks a file beside `target`, with default permissions and the unused name "TARGET.PROCESS-NUMBER.tmp",
/// which is stored in `name`. Returns its descriptor, or -1 and sets errno.
int createTemporary(const std::filesystem::path &target, std::string &name);

/// Returns the folder of a file.
std::filesystem::path folderOf(const std::filesystem::path &file);

/// Removes the temporary files of one target that killed programs have left behind: those whose process no longer
/// exists, and which nobody has locked, such as a process on another machine that shares the folder.
void removeStaleTemporaries(const std::filesystem::path &target);

} // namespace forefront
