#include "core/files/text/temporary_names.hpp"

#include "core/engine/platform/file_handle.hpp"
#include "core/engine/platform/process.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <optional>
#include <string_view>

namespace forefront {

namespace {

constexpr std::string_view kEnding = ".tmp";

/// Returns the process that made a temporary file of a target; empty if the name is that of another file.
std::optional<long> makerOf(std::string_view name, std::string_view target) {
    if (!name.starts_with(target) || !name.ends_with(kEnding) || name.size() < target.size() + kEnding.size() ||
        name[target.size()] != '.') {
        return std::nullopt;
    }
    name = name.substr(target.size() + 1);
    long process = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), process);
    return read.ec == std::errc() && process > 0 && *read.ptr == '-' ? std::optional(process) : std::nullopt;
}

/// Returns true if nobody has locked a file, as its maker does while it writes.
bool isUnlocked(const std::filesystem::path &file) {
    const FileHandle handle = openFile(file, FileAccess::Inspect);
    if (handle < 0) {
        return false;
    }
    const bool unlocked = lockFile(handle);
    closeFile(handle);
    return unlocked;
}

} // namespace

int createTemporary(const std::filesystem::path &target, std::string &name) {
    constexpr int kAttempts = 1000;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        name = target.string() + '.' + std::to_string(processNumber()) + '-' + std::to_string(attempt) +
               std::string(kEnding);
        const FileHandle handle = openFile(name, FileAccess::Create);
        if (handle >= 0) {
            lockFile(handle); // where the file system can
            return handle;
        }
        if (errno != EEXIST) {
            return -1;
        }
    }
    return -1;
}

std::filesystem::path folderOf(const std::filesystem::path &file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

void removeStaleTemporaries(const std::filesystem::path &target) {
    const std::string name = target.filename().string();
    const std::filesystem::path folder = folderOf(target);
    std::error_code failed;
    for (std::filesystem::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        const std::optional<long> maker = makerOf(entry->path().filename().string(), name);
        const bool dead = maker && *maker != processNumber() && processIsGone(*maker);
        if (dead && isUnlocked(entry->path())) {
            std::error_code ignored;
            std::filesystem::remove(entry->path(), ignored);
        }
    }
}

} // namespace forefront
