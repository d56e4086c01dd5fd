#include "core/files/source/file_stamp.hpp"

#include "core/engine/base/hash.hpp"
#include "core/files/source/source.hpp"

#include <cerrno>
#include <ctime>
#include <limits>
#include <string>
#include <sys/stat.h>

namespace forefront {

namespace {

std::int64_t nanoseconds(const struct timespec &time) {
    constexpr std::int64_t kPerSecond = 1'000'000'000;
    return static_cast<std::int64_t>(time.tv_sec) * kPerSecond + time.tv_nsec;
}

/// Returns the signs in the status of a file, as of now.
FileStamp signsOf(const struct stat &status) {
    FileStamp stamp;
    stamp.kind = FileStamp::Kind::File;
    stamp.size = static_cast<std::uint64_t>(status.st_size);
    stamp.device = static_cast<std::uint64_t>(status.st_dev);
    stamp.inode = static_cast<std::uint64_t>(status.st_ino);
    stamp.modified = nanoseconds(status.st_mtim);
    struct timespec now {};
    constexpr std::int64_t kCoarsestStep = 3'000'000'000; // FAT keeps times in steps of two seconds
    stamp.settled = ::clock_gettime(CLOCK_REALTIME, &now) == 0 && stamp.modified + kCoarsestStep < nanoseconds(now);
    return stamp;
}

bool sameSigns(const FileStamp &a, const FileStamp &b) {
    return a.size == b.size && a.device == b.device && a.inode == b.inode && a.modified == b.modified;
}

} // namespace

FileStamp stampOf(const std::filesystem::path &file, const FileStamp &before) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) {
        FileStamp missing;
        missing.kind = errno == ENOENT || errno == ENOTDIR ? FileStamp::Kind::Missing : FileStamp::Kind::Unknown;
        return missing;
    }
    if (!S_ISREG(status.st_mode)) {
        return {};
    }
    FileStamp stamp = signsOf(status); // before the content, so that a change while it is read is found the next time
    if (before.kind == FileStamp::Kind::File && before.settled && sameSigns(before, stamp)) {
        return before;
    }
    const Result<std::string> content = readRegularFile(file, std::numeric_limits<std::size_t>::max());
    if (!content) {
        return {};
    }
    stamp.hash = stampOfContent(*content).hash;
    return stamp;
}

FileStamp stampOfContent(std::string_view content) {
    Hash64 hash;
    hash.add(content);
    FileStamp stamp;
    stamp.kind = FileStamp::Kind::File;
    stamp.hash = hash.value();
    return stamp;
}

} // namespace forefront
