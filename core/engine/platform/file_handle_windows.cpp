#ifdef _WIN32

#include "core/engine/platform/file_handle.hpp"

#include <climits>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <io.h>
#include <iterator>
#include <sys/stat.h>
#include <windows.h>

namespace forefront {

namespace {

constexpr int kFlags[] = {
    _O_RDONLY, _O_RDONLY, _O_RDONLY, _O_RDWR, _O_WRONLY, _O_WRONLY | _O_CREAT | _O_EXCL, _O_RDWR | _O_CREAT | _O_TRUNC};
static_assert(std::size(kFlags) == static_cast<std::size_t>(FileAccess::ReplaceOwned) + 1);

unsigned atMostInt(std::size_t bytes) {
    return static_cast<unsigned>(std::min<std::size_t>(bytes, INT_MAX));
}

FileStatus statusFrom(const struct _stat64 &status, bool terminal) {
    constexpr std::int64_t kPerSecond = 1'000'000'000;
    FileStatus result;
    const unsigned kind = status.st_mode & _S_IFMT;
    result.kind = kind == _S_IFREG   ? FileStatus::Kind::Regular
                  : kind == _S_IFDIR ? FileStatus::Kind::Folder
                  : terminal         ? FileStatus::Kind::Terminal
                  : kind == _S_IFCHR ? FileStatus::Kind::Device
                                     : FileStatus::Kind::Other;
    result.size = status.st_size > 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
    result.modified = static_cast<std::int64_t>(status.st_mtime) * kPerSecond;
    result.permissions = status.st_mode & 0777U;
    return result;
}

} // namespace

FileHandle openFile(const std::filesystem::path &path, FileAccess access) {
    return ::_wopen(path.c_str(), kFlags[static_cast<std::size_t>(access)] | _O_BINARY | _O_NOINHERIT,
                    _S_IREAD | _S_IWRITE);
}

bool closeFile(FileHandle file) {
    return ::_close(file) == 0;
}

std::FILE *streamOf(FileHandle file) {
    return ::_fdopen(file, "rb");
}

std::ptrdiff_t readSome(FileHandle file, char *buffer, std::size_t bytes) {
    return ::_read(file, buffer, atMostInt(bytes));
}

std::ptrdiff_t writeSome(FileHandle file, std::string_view bytes) {
    return ::_write(file, bytes.data(), atMostInt(bytes.size()));
}

bool cutFile(FileHandle file, std::uint64_t size) {
    const auto end = static_cast<__int64>(size);
    return ::_chsize_s(file, end) == 0 && ::_lseeki64(file, end, SEEK_SET) >= 0;
}

bool syncFile(FileHandle file) {
    return ::_commit(file) == 0 || errno == EINVAL || errno == EBADF; // EBADF: consoles and pipes
}

void syncFolder(const std::filesystem::path & /*folder*/) {}

bool lockFile(FileHandle file) {
    OVERLAPPED place{};
    auto *const handle = reinterpret_cast<HANDLE>(::_get_osfhandle(file));
    // One byte far behind the end: other bytes stay readable for other programs.
    place.OffsetHigh = 0x7fffffff;
    return LockFileEx(handle, LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &place) != 0;
}

bool statusOf(FileHandle file, FileStatus &status) {
    struct _stat64 found {};
    if (::_fstat64(file, &found) != 0) {
        return false;
    }
    status = statusFrom(found, ::_isatty(file) != 0);
    BY_HANDLE_FILE_INFORMATION information{};
    if (GetFileInformationByHandle(reinterpret_cast<HANDLE>(::_get_osfhandle(file)), &information) != 0) {
        status.device = information.dwVolumeSerialNumber;
        status.id = (static_cast<std::uint64_t>(information.nFileIndexHigh) << 32U) | information.nFileIndexLow;
    }
    return true;
}

bool statusOf(const std::filesystem::path &path, FileStatus &status) {
    struct _stat64 found {};
    if (::_wstat64(path.c_str(), &found) != 0) {
        return false;
    }
    status = statusFrom(found, false);
    if (status.kind != FileStatus::Kind::Regular) {
        return true;
    }
    if (const FileHandle file = openFile(path, FileAccess::Read); file >= 0) { // for its identity
        FileStatus opened;
        if (statusOf(file, opened)) {
            status.device = opened.device;
            status.id = opened.id;
        }
        closeFile(file);
    }
    return true;
}

void copyPermissions(FileHandle /*file*/, const FileStatus & /*from*/) {} // inherited from the folder

bool isWritable(const std::filesystem::path &path, const FileStatus & /*status*/) {
    constexpr int kWrite = 2;
    return ::_waccess(path.c_str(), kWrite) == 0;
}

void useBinaryStandardStreams() {
    ::_setmode(kStandardInput, _O_BINARY);
    ::_setmode(kStandardOutput, _O_BINARY);
}

bool errorsGoToTerminal() {
    constexpr int kStandardError = 2;
    return ::_isatty(kStandardError) != 0;
}

} // namespace forefront

#endif
