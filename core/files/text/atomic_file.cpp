#include "core/files/text/atomic_file.hpp"

#include "core/engine/base/cancelled.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace forefront {

namespace {

/// Opens a file with an unused name beside `target` and default permissions.
int createBeside(const std::filesystem::path &target, std::string &name) {
    constexpr int kAttempts = 1000;
    constexpr mode_t kNewFileMode = 0666;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        name = target.string() + '.' + std::to_string(::getpid()) + '-' + std::to_string(attempt) + ".tmp";
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNewFileMode);
        if (descriptor >= 0 || errno != EEXIST) {
            return descriptor;
        }
    }
    return -1;
}

/// Returns the file that a path leads to through symbolic links, which need not exist.
std::filesystem::path followed(std::filesystem::path path) {
    constexpr int kMaxLinks = 40; // as Linux follows
    std::error_code fault;
    for (int k = 0; k < kMaxLinks && std::filesystem::is_symlink(path, fault); ++k) {
        const std::filesystem::path next = std::filesystem::read_symlink(path, fault);
        if (fault) {
            break;
        }
        path = path.parent_path() / next; // next replaces the folder if it is absolute
    }
    return path;
}

/// Makes the new name itself durable; failure is ignored, since some file systems cannot do that.
void syncFolder(const std::filesystem::path &folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        ::fsync(descriptor);
        ::close(descriptor);
    }
}

} // namespace

AtomicFile::AtomicFile(const std::filesystem::path &path, const Progress &progress, std::size_t expectedBytes)
    : path_(path), target_(path), progress_(progress), expectedBytes_(expectedBytes) {
    std::error_code ignored;
    const auto kind = std::filesystem::status(path, ignored).type();
    if (kind == std::filesystem::file_type::directory) {
        fail("write", EISDIR);
        return;
    }
    if (kind != std::filesystem::file_type::not_found && kind != std::filesystem::file_type::regular &&
        kind != std::filesystem::file_type::none) {
        descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0) {
            fail("open", errno);
        }
        return;
    }
    target_ = followed(path);
    descriptor_ = createBeside(target_, temporary_);
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

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
    if (!temporary_.empty()) {
        ::unlink(temporary_.c_str());
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
    if (status_.empty() && !temporary_.empty() && ::fsync(descriptor_) != 0 && errno != EINVAL) {
        fail("flush", errno);
    }
    if (descriptor_ >= 0 && ::close(descriptor_) != 0 && status_.empty()) {
        fail("close", errno);
    }
    descriptor_ = -1;
    if (status_.empty() && !temporary_.empty()) {
        if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
            fail("rename the finished file to", errno);
        } else {
            temporary_.clear();
            syncFolder(target_.has_parent_path() ? target_.parent_path() : std::filesystem::path("."));
        }
    }
    if (status_.empty() && expectedBytes_ > 0) {
        progress_("writing", 1.0);
    }
    return status_;
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
