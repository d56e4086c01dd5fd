#include "core/drawing/recovery/journal_record.hpp"
#include "core/drawing/recovery/recovery_journal.hpp"
#include "core/engine/platform/file_handle.hpp"

#include <algorithm>
#include <cerrno>
#include <utility>

namespace forefront {
namespace {

constexpr std::int64_t kNanoseconds = 1'000'000'000; // in a second

std::string readAll(FileHandle file) {
    std::string bytes;
    char buffer[1 << 16];
    for (;;) {
        const std::ptrdiff_t count = readSome(file, buffer, sizeof buffer);
        if (count > 0) {
            bytes.append(buffer, static_cast<std::size_t>(count));
        } else if (count == 0 || errno != EINTR) {
            return bytes;
        }
    }
}

/// Returns true if the open file still has that name: it may have been replaced or removed.
bool stillNamed(FileHandle open, const std::filesystem::path &file, FileStatus &status) {
    FileStatus named;
    return statusOf(open, status) && statusOf(file, named) && status.kind == FileStatus::Kind::Regular &&
           status.sameFile(named);
}

} // namespace

OrphanedJournal::OrphanedJournal(std::filesystem::path file, int descriptor, JournalContent content,
                                 std::time_t written)
    : file_(std::move(file)), savedAt_(std::move(content.path)), descriptor_(descriptor),
      title_(std::move(content.title)), text_(std::move(content.text).value_or(std::string())),
      savedHash_(content.savedHash), written_(written) {}

OrphanedJournal::~OrphanedJournal() {
    if (descriptor_ >= 0) {
        closeFile(descriptor_);
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
        closeFile(std::exchange(descriptor_, -1));
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
        const FileHandle descriptor = openFile(file, FileAccess::Change);
        if (descriptor < 0) {
            continue;
        }
        FileStatus status;
        const bool free = lockFile(descriptor);
        held += free ? 0 : 1;
        if (!free || !stillNamed(descriptor, file, status)) {
            closeFile(descriptor);
            continue;
        }
        JournalContent content = readJournal(readAll(descriptor));
        const bool recoverable = content.text.has_value();
        OrphanedJournal orphan(file, descriptor, std::move(content),
                               static_cast<std::time_t>(status.modified / kNanoseconds));
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
