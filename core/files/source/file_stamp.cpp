#include "core/files/source/file_stamp.hpp"

#include "core/engine/base/hash.hpp"
#include "core/engine/platform/file_handle.hpp"
#include "core/files/source/source.hpp"

#include <cerrno>
#include <chrono>
#include <limits>
#include <string>

namespace forefront {

namespace {

/// Returns the nanoseconds since 1970.
std::int64_t now() {
    const auto elapsed = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(elapsed).count();
}

/// Returns the signs in the status of a file, as of now.
FileStamp signsOf(const FileStatus &status) {
    FileStamp stamp;
    stamp.kind = FileStamp::Kind::File;
    stamp.size = status.size;
    stamp.device = status.device;
    stamp.inode = status.id;
    stamp.modified = status.modified;
    constexpr std::int64_t kCoarsestStep = 3'000'000'000; // FAT keeps times in steps of two seconds
    stamp.settled = stamp.modified + kCoarsestStep < now();
    return stamp;
}

bool sameSigns(const FileStamp &a, const FileStamp &b) {
    return a.size == b.size && a.device == b.device && a.inode == b.inode && a.modified == b.modified;
}

} // namespace

FileStamp stampOf(const std::filesystem::path &file, const FileStamp &before) {
    FileStatus status;
    if (!statusOf(file, status)) {
        FileStamp missing;
        missing.kind = errno == ENOENT || errno == ENOTDIR ? FileStamp::Kind::Missing : FileStamp::Kind::Unknown;
        return missing;
    }
    if (status.kind != FileStatus::Kind::Regular) {
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
