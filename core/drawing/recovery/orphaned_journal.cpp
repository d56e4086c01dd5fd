#include "core/drawing/recovery/journal_record.hpp"
#include "core/drawing/recovery/recovery_journal.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace forefront {
namespace {

std::string readAll(int descriptor) {
    std::string bytes;
    char buffer[1 << 16];
    for (;;) {
        const ssize_t count = ::read(descriptor, buffer, sizeof buffer);
        if (count > 0) {
            bytes.append(buffer, static_cast<std::size_t>(count));
        } else if (count == 0 || errno != EINTR) {
            return bytes;
        }
    }
}

/// Returns true if the descriptor still belongs to the file of that name, which may have been replaced or removed.
bool stillNamed(int descriptor, const std::filesystem::path &file, struct stat &status) {
    struct stat named {};
    return ::fstat(descriptor, &status) == 0 && ::stat(file.c_str(), &named) == 0 && S_ISREG(status.st_mode) &&
           status.st_ino == named.st_ino && status.st_dev == named.st_dev;
}

} // namespace

OrphanedJournal::OrphanedJournal(std::filesystem::path file, int descriptor, JournalContent content,
                                 std::time_t written)
    : file_(std::move(file)), savedAt_(std::move(content.path)), descriptor_(descriptor),
      title_(std::move(content.title)), text_(std::move(content.text).value_or(std::string())),
      savedHash_(content.savedHash), written_(written) {}

OrphanedJournal::~OrphanedJournal() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

OrphanedJournal::OrphanedJournal(OrphanedJournal &&other) noexcept
    : file_(std::move(other.file_)), savedAt_(std::move(other.savedAt_)),
      descriptor_(std::exchange(other.descriptor_, -1)), title_(std::move(other.title_)), text_(std::move(other.text_)),
      savedHash_(other.savedHash_), written_(other.written_) {}

OrphanedJournal &OrphanedJournal::operator=(OrphanedJournal &&other) noexcept {
    std::swap(file_, other.file_);
    std::swap(savedAt_, other.savedAt_);
    std::swap(descriptor_, other.descriptor_);
    std::swap(title_, other.title_);
    std::swap(text_, other.text_);
    std::swap(savedHash_, other.savedHash_);
    std::swap(written_, other.written_);
    return *this;
}

void OrphanedJournal::discard() {
    if (descriptor_ >= 0) {
        std::error_code ignored;
        std::filesystem::remove(file_, ignored);
        ::close(std::exchange(descriptor_, -1));
    }
}

std::vector<OrphanedJournal> findOrphanedJournals(const std::filesystem::path &folder, std::size_t *locked) {
    std::size_t held = 0;
    std::vector<OrphanedJournal> orphans;
    std::error_code failed;
    std::vector<std::filesystem::path> files;
    for (std::filesystem::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        if (entry->path().extension() == ".journal") {
            files.push_back(entry->path());
        }
    }
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path &file : files) {
        const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
        if (descriptor < 0) {
            continue;
        }
        struct stat status {};
        const bool free = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
        held += free ? 0 : 1;
        if (!free || !stillNamed(descriptor, file, status)) {
            ::close(descriptor);
            continue;
        }
        JournalContent content = readJournal(readAll(descriptor));
        const bool recoverable = content.text.has_value();
        OrphanedJournal orphan(file, descriptor, std::move(content), status.st_mtime);
        if (recoverable) {
            orphans.push_back(std::move(orphan));
        } else {
            orphan.discard();
        }
    }
    if (locked != nullptr) {
        *locked = held;
    }
    std::stable_sort(orphans.begin(), orphans.end(),
                     [](const auto &a, const auto &b) { return a.written() > b.written(); });
    return orphans;
}

} // namespace forefront
