#include "core/files/text/temporary_names.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <fcntl.h>
#include <optional>
#include <string_view>
#include <sys/file.h>
#include <sys/types.h>
#include <unistd.h>

namespace forefront {

namespace {

constexpr std::string_view kEnding = ".tmp";

/// Returns the process that made a temporary file of a target; empty if the name is that of another file.
std::optional<pid_t> makerOf(std::string_view name, std::string_view target) {
    if (!name.starts_with(target) || !name.ends_with(kEnding) || name.size() < target.size() + kEnding.size() ||
        name[target.size()] != '.') {
        return std::nullopt;
    }
    name = name.substr(target.size() + 1);
    pid_t process = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), process);
    return read.ec == std::errc() && process > 0 && *read.ptr == '-' ? std::optional(process) : std::nullopt;
}

/// Returns true if nobody has locked a file, as its maker does while it writes.
bool isUnlocked(const std::filesystem::path &file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) {
        return false;
    }
    const bool unlocked = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    ::close(descriptor);
    return unlocked;
}

} // namespace

int createTemporary(const std::filesystem::path &target, std::string &name) {
    constexpr int kAttempts = 1000;
    constexpr mode_t kNewFileMode = 0666;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        name =
            target.string() + '.' + std::to_string(::getpid()) + '-' + std::to_string(attempt) + std::string(kEnding);
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNewFileMode);
        if (descriptor >= 0) {
            ::flock(descriptor, LOCK_EX | LOCK_NB); // where the file system can
            return descriptor;
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

void syncFolder(const std::filesystem::path &folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        ::fsync(descriptor);
        ::close(descriptor);
    }
}

void removeStaleTemporaries(const std::filesystem::path &target) {
    const std::string name = target.filename().string();
    const std::filesystem::path folder = folderOf(target);
    std::error_code failed;
    for (std::filesystem::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        const std::optional<pid_t> maker = makerOf(entry->path().filename().string(), name);
        const bool dead = maker && *maker != ::getpid() && ::kill(*maker, 0) != 0 && errno == ESRCH;
        if (dead && isUnlocked(entry->path())) {
            std::error_code ignored;
            std::filesystem::remove(entry->path(), ignored);
        }
    }
}

} // namespace forefront
