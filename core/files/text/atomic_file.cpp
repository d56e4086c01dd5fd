#include "core/files/text/atomic_file.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/platform/file_handle.hpp"
#include "core/files/text/temporary_names.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace forefront {

namespace {

/// Follows links up to a file, which need not exist. Returns the path itself if the links form a circle.
std::filesystem::path followLinks(const std::filesystem::path &path) {
    constexpr int kMostLinks = 40; // as in Linux
    std::filesystem::path file = path;
    std::error_code failed;
    for (int k = 0; k < kMostLinks && std::filesystem::is_symlink(file, failed); ++k) {
        const std::filesystem::path next = std::filesystem::read_symlink(file, failed);
        if (failed) {
            return path;
        }
        file = next.is_absolute() ? next : file.parent_path() / next;
    }
    return std::filesystem::is_symlink(file, failed) ? path : file;
}

bool isPlainOrMissing(std::filesystem::file_type kind) {
    return kind == std::filesystem::file_type::not_found || kind == std::filesystem::file_type::regular ||
           kind == std::filesystem::file_type::none;
}

void removeQuietly(const std::filesystem::path &file) {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
}

/// Renames a file and replaces one of the new name. Returns 0 or the number of the error.
int moveOver(const std::filesystem::path &from, const std::filesystem::path &to) {
    std::error_code failed;
    std::filesystem::rename(from, to, failed);
    return failed ? failed.default_error_condition().value() : 0;
}

} // namespace

Status checkReplaceable(const std::filesystem::path &path) {
    FileStatus status;
    if (!statusOf(path, status) || status.kind != FileStatus::Kind::Regular) {
        return {};
    }
    return isWritable(path, status) ? Status()
                                    : error("cannot-write", "cannot write the file: it is write-protected",
                                            "allow writing with chmod u+w, or choose another name");
}

AtomicFile::AtomicFile(const std::filesystem::path &path, const Progress &progress, std::size_t expectedBytes)
    : path_(path), target_(path), progress_(progress), expectedBytes_(expectedBytes) {
    std::error_code ignored;
    const auto kind = std::filesystem::status(path, ignored).type();
    if (kind == std::filesystem::file_type::directory) {
        fail("write", EISDIR);
        return;
    }
    if (!isPlainOrMissing(kind)) {
        openDirectly();
        return;
    }
    status_ = checkReplaceable(path);
    if (!status_.empty()) {
        status_.front().file = path.string();
        return;
    }
    target_ = followLinks(path);
    removeStaleTemporaries(target_);
    descriptor_ = createTemporary(target_, temporary_);
    if (descriptor_ < 0) {
        const int number = errno;
        temporary_.clear();
        fail("create a file in the folder of", number);
        return;
    }
    if (FileStatus replaced; statusOf(target_, replaced)) {
        copyPermissions(descriptor_, replaced);
    }
}

/// Opens a device or pipe, which cannot be replaced.
void AtomicFile::openDirectly() {
    descriptor_ = openFile(path_, FileAccess::Write);
    if (descriptor_ < 0) {
        fail("open", errno);
    }
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) {
        closeFile(descriptor_);
    }
    if (!temporary_.empty()) {
        removeQuietly(temporary_);
    }
    if (!previous_.empty()) {
        removeQuietly(previous_);
    }
}

bool AtomicFile::write(std::string_view bytes) {
    while (status_.empty() && !bytes.empty()) {
        if (progress_.cancelled()) {
            status_ = cancelled("writing");
            status_.front().file = path_.string();
            break;
        }
        constexpr std::size_t kLargest = std::size_t{8} << 20;
        const std::ptrdiff_t done = writeSome(descriptor_, bytes.substr(0, kLargest));
        if (done < 0) {
            if (errno != EINTR) {
                fail("write", errno);
            }
            continue;
        }
        written_ += static_cast<std::size_t>(done);
        bytes.remove_prefix(static_cast<std::size_t>(done));
        if (expectedBytes_ > 0) {
            progress_("writing", std::min(0.99, static_cast<double>(written_) / static_cast<double>(expectedBytes_)));
        }
    }
    return status_.empty();
}

Status AtomicFile::commit() {
    if (finish().empty() && !temporary_.empty()) {
        if (const int number = moveOver(temporary_, target_); number != 0) {
            fail("rename the finished file to", number);
        } else {
            temporary_.clear();
            syncFolder(folderOf(target_));
        }
    }
    return status_;
}

Status AtomicFile::finish() {
    if (status_.empty() && !temporary_.empty() && !syncFile(descriptor_)) {
        fail("flush", errno);
    }
    if (descriptor_ >= 0 && !closeFile(descriptor_) && status_.empty()) {
        fail("close", errno);
    }
    descriptor_ = -1;
    if (status_.empty() && expectedBytes_ > 0) {
        progress_("writing", 1.0);
    }
    return status_;
}

Status AtomicFile::publish() {
    if (!status_.empty() || temporary_.empty()) {
        return status_;
    }
    previous_ = temporary_ + ".old.tmp";
    std::error_code failed;
    std::filesystem::create_hard_link(target_, previous_, failed);
    if (failed) {
        previous_.clear(); // nothing is replaced, or the file system knows no second names
    }
    if (const int number = moveOver(temporary_, target_); number != 0) {
        fail("rename the finished file to", number);
        return status_;
    }
    temporary_.clear();
    published_ = true;
    return status_;
}

void AtomicFile::withdraw() {
    if (!published_) {
        return;
    }
    if (previous_.empty()) {
        removeQuietly(target_);
    } else if (moveOver(previous_, target_) == 0) {
        previous_.clear();
    }
    published_ = false;
}

void AtomicFile::release() {
    if (!previous_.empty()) {
        removeQuietly(previous_);
        previous_.clear();
    }
}

void AtomicFile::fail(const std::string &action, int number) {
    status_ = error("cannot-write", "cannot " + action + " " + path_.string() + ": " + std::strerror(number),
                    "choose another folder or check its permissions and free space");
    status_.front().file = path_.string();
}

Status writeTextFile(const std::filesystem::path &path, const std::function<void(TextWriter &)> &fill,
                     const Progress &progress, std::size_t expectedBytes) {
    AtomicFile file(path, progress, expectedBytes);
    TextWriter out(file);
    fill(out);
    out.flush();
    return file.commit();
}

Status writeFileAtomically(const std::filesystem::path &path, std::string_view bytes) {
    AtomicFile file(path);
    file.write(bytes);
    return file.commit();
}

} // namespace forefront
