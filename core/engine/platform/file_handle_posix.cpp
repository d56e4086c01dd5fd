#ifndef _WIN32

#include "core/engine/platform/file_handle.hpp"

#include <cerrno>
#include <fcntl.h>
#include <iterator>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace forefront {

namespace {

constexpr int kFlags[] = {
    O_RDONLY, O_RDONLY | O_NONBLOCK,       O_RDONLY | O_NOFOLLOW | O_NONBLOCK, O_RDWR | O_NOFOLLOW | O_NONBLOCK,
    O_WRONLY, O_WRONLY | O_CREAT | O_EXCL, O_RDWR | O_CREAT | O_TRUNC};
static_assert(std::size(kFlags) == static_cast<std::size_t>(FileAccess::ReplaceOwned) + 1);

FileStatus statusFrom(const struct stat &status, bool terminal) {
    constexpr std::int64_t kPerSecond = 1'000'000'000;
    FileStatus result;
    const bool device = S_ISBLK(status.st_mode) || S_ISCHR(status.st_mode);
    result.kind = S_ISREG(status.st_mode)   ? FileStatus::Kind::Regular
                  : S_ISDIR(status.st_mode) ? FileStatus::Kind::Folder
                  : terminal                ? FileStatus::Kind::Terminal
                  : device                  ? FileStatus::Kind::Device
                                            : FileStatus::Kind::Other;
    result.size = status.st_size > 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
    result.device = static_cast<std::uint64_t>(status.st_dev);
    result.id = static_cast<std::uint64_t>(status.st_ino);
#ifdef __APPLE__
    const struct timespec &modified = status.st_mtimespec;
#else
    const struct timespec &modified = status.st_mtim;
#endif
    result.modified = static_cast<std::int64_t>(modified.tv_sec) * kPerSecond + modified.tv_nsec;
    result.permissions = static_cast<unsigned>(status.st_mode) & 07777U;
    return result;
}

} // namespace

FileHandle openFile(const std::filesystem::path &path, FileAccess access) {
    const mode_t mode = access == FileAccess::ReplaceOwned ? 0600 : 0666;
    return ::open(path.c_str(), kFlags[static_cast<std::size_t>(access)] | O_CLOEXEC, mode);
}

bool closeFile(FileHandle file) {
    return ::close(file) == 0;
}

std::FILE *streamOf(FileHandle file) {
    return ::fdopen(file, "rb");
}

std::ptrdiff_t readSome(FileHandle file, char *buffer, std::size_t bytes) {
    return ::read(file, buffer, bytes);
}

std::ptrdiff_t writeSome(FileHandle file, std::string_view bytes) {
    return ::write(file, bytes.data(), bytes.size());
}

bool cutFile(FileHandle file, std::uint64_t size) {
    const auto end = static_cast<off_t>(size);
    return ::ftruncate(file, end) == 0 && ::lseek(file, end, SEEK_SET) >= 0;
}

bool syncFile(FileHandle file) {
    return ::fsync(file) == 0 || errno == EINVAL;
}

void syncFolder(const std::filesystem::path &folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        ::fsync(descriptor);
        ::close(descriptor);
    }
}

bool lockFile(FileHandle file) {
    return ::flock(file, LOCK_EX | LOCK_NB) == 0;
}

bool statusOf(FileHandle file, FileStatus &status) {
    struct stat found {};
    if (::fstat(file, &found) != 0) {
        return false;
    }
    status = statusFrom(found, S_ISCHR(found.st_mode) && ::isatty(file) == 1);
    return true;
}

bool statusOf(const std::filesystem::path &path, FileStatus &status) {
    struct stat found {};
    if (::stat(path.c_str(), &found) != 0) {
        return false;
    }
    status = statusFrom(found, false);
    return true;
}

void copyPermissions(FileHandle file, const FileStatus &from) {
    static_cast<void>(::fchmod(file, static_cast<mode_t>(from.permissions)));
}

bool isWritable(const std::filesystem::path &path, const FileStatus &status) {
    constexpr unsigned kWriteBits = 0222;
    return (status.permissions & kWriteBits) != 0 && ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
}

void useBinaryStandardStreams() {}

bool errorsGoToTerminal() {
    return ::isatty(STDERR_FILENO) == 1;
}

} // namespace forefront

#endif
