#include "core/files/text/atomic_file.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/files/text/temporary_names.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

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

} // namespace

Status checkReplaceable(const std::filesystem::path &path) {
    constexpr mode_t kWriteBits = 0222; // which do not bind the superuser, who may not have meant it either
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) {
        return {};
    }
    const bool allowed =
        (status.st_mode & kWriteBits) != 0 && ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
    return allowed ? Status()
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
    struct stat replaced {};
    if (::stat(target_.c_str(), &replaced) == 0) {
        static_cast<void>(::fchmod(descriptor_, replaced.st_mode & 07777U));
    }
}

/// Opens a device or pipe, which cannot be replaced.
void AtomicFile::openDirectly() {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) {
        fail("open", errno);
    }
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
    if (!temporary_.empty()) {
        ::unlink(temporary_.c_str());
    }
    if (!previous_.empty()) {
        ::unlink(previous_.c_str());
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
        const ssize_t done = ::write(descriptor_, bytes.data(), std::min(bytes.size(), kLargest));
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
        if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
            fail("rename the finished file to", errno);
        } else {
            temporary_.clear();
            syncFolder(folderOf(target_));
        }
    }
    return status_;
}

Status AtomicFile::finish() {
    if (status_.empty() && !temporary_.empty() && ::fsync(descriptor_) != 0 && errno != EINVAL) {
        fail("flush", errno);
    }
    if (descriptor_ >= 0 && ::close(descriptor_) != 0 && status_.empty()) {
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
    if (::link(target_.c_str(), previous_.c_str()) != 0) {
        previous_.clear(); // nothing is replaced, or the file system knows no second names
    }
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
        fail("rename the finished file to", errno);
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
        ::unlink(target_.c_str());
    } else if (::rename(previous_.c_str(), target_.c_str()) == 0) {
        previous_.clear();
    }
    published_ = false;
}

void AtomicFile::release() {
    if (!previous_.empty()) {
        ::unlink(previous_.c_str());
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
