#include "core/drawing/recovery/recovery_journal.hpp"

#include "core/drawing/recovery/journal_record.hpp"
#include "core/engine/platform/file_handle.hpp"
#include "core/engine/platform/process.hpp"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

namespace forefront {
namespace {

using namespace std::chrono_literals;

/// Minimum and maximum time between two writes; slow writes are followed by longer pauses.
constexpr auto kShortestRest = 200ms;
constexpr auto kLongestRest = 700ms;
/// A journal is rewritten when it exceeds the text of its document by this factor.
constexpr std::uint64_t kCompactFactor = 4, kCompactSlack = 1U << 20;

bool writeAll(FileHandle file, std::string_view bytes) {
    while (!bytes.empty()) {
        const std::ptrdiff_t written = writeSome(file, bytes);
        if (written < 0) {
            if (errno == EINTR) {
                continue;
            }
            return false;
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return syncFile(file);
}

/// Creates a locked file that findOrphanedJournals() does not see yet. Returns -1 and sets errno on failure.
FileHandle createLocked(const std::filesystem::path &path) {
    const FileHandle descriptor = openFile(path, FileAccess::ReplaceOwned);
    if (descriptor >= 0 && !lockFile(descriptor)) {
        closeFile(descriptor);
        return -1;
    }
    return descriptor;
}

/// Closes and removes what createLocked() returned.
void abandon(const std::filesystem::path &path, FileHandle file) {
    if (file >= 0) {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
        closeFile(file);
    }
}

} // namespace

std::filesystem::path stateFolder() {
    const char *state = std::getenv("XDG_STATE_HOME");
    if (state != nullptr && std::filesystem::path(state).is_absolute()) {
        return std::filesystem::path(state) / "forefront";
    }
    const char *home = std::getenv("HOME");
    if (home != nullptr && *home != '\0') {
        return std::filesystem::path(home) / ".local" / "state" / "forefront";
    }
    std::error_code failed;
    const std::filesystem::path temporary = std::filesystem::temp_directory_path(failed);
    return (failed ? std::filesystem::path("/tmp") : temporary) / ("forefront-" + std::to_string(userNumber()));
}

RecoveryJournal::RecoveryJournal(std::filesystem::path folder, Serialise serialise)
    : folder_(std::move(folder)), serialise_(std::move(serialise)),
      thread_([this](const std::stop_token &stop) { work(stop); }) {}

RecoveryJournal::~RecoveryJournal() {
    thread_.request_stop();
    thread_.join();
    if (descriptor_ >= 0) {
        std::error_code ignored;
        std::filesystem::remove(file_, ignored);
        closeFile(descriptor_);
    }
}

void RecoveryJournal::record(std::shared_ptr<const Document> document, Place place) {
    record([shared = std::move(document)] { return shared; }, std::move(place));
}

void RecoveryJournal::record(Make make, Place place) {
    const std::lock_guard lock(mutex_);
    pending_ = std::make_unique<Entry>(Entry{std::move(make), std::move(place)});
    changed_.notify_all();
}

void RecoveryJournal::recordSaved() {
    const std::lock_guard lock(mutex_);
    pending_ = std::make_unique<Entry>();
    changed_.notify_all();
}

void RecoveryJournal::flush() {
    std::unique_lock lock(mutex_);
    urgent_ = true;
    changed_.notify_all();
    changed_.wait(lock, [this] { return !pending_ && !writing_; });
    urgent_ = false;
}

bool RecoveryJournal::resting() const {
    const std::lock_guard lock(mutex_);
    return !pending_ && !writing_;
}

Diagnostics RecoveryJournal::takeFaults() {
    const std::lock_guard lock(mutex_);
    return std::exchange(faults_, {});
}

std::filesystem::path RecoveryJournal::file() const {
    const std::lock_guard lock(mutex_);
    return file_;
}

void RecoveryJournal::work(const std::stop_token &stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [this] { return pending_ != nullptr; })) {
        const std::unique_ptr<Entry> entry = std::move(pending_);
        writing_ = true;
        lock.unlock();
        const auto begun = std::chrono::steady_clock::now();
        write(*entry);
        const auto taken =
            std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begun);
        lock.lock();
        writing_ = false;
        changed_.notify_all();
        changed_.wait_for(lock, stop, std::clamp<std::chrono::milliseconds>(3 * taken, kShortestRest, kLongestRest),
                          [this] { return urgent_; });
    }
}

std::string RecoveryJournal::placeRecords(const Place &place) {
    return encodeRecord(JournalRecord::Path, place.savedAt.string()) + encodeRecord(JournalRecord::Title, place.title) +
           encodeRecord(JournalRecord::SavedHash, encodeHash(place.savedHash));
}

void RecoveryJournal::write(const Entry &entry) {
    if (!entry.document) {
        if (hasText_ && append(encodeRecord(JournalRecord::Saved, {}))) {
            failed_ = false;
        }
        return;
    }
    try {
        writeText(entry, serialise_(*entry.document()));
    } catch (const std::exception &exception) { // such as one for lack of memory
        hasText_ = false;                       // a later entry is written whole
        fail(exception.what());
    }
}

void RecoveryJournal::writeText(const Entry &entry, std::string text) {
    std::string bytes;
    if (!hasText_ || entry.place != place_) {
        bytes += placeRecords(entry.place);
    }
    bytes += hasText_ ? encodeRecord(JournalRecord::Delta, encodeDelta(text_, text))
                      : encodeRecord(JournalRecord::FullText, text);
    text_ = std::move(text);
    place_ = entry.place;
    const bool tooLarge = size_ + bytes.size() > kCompactFactor * text_.size() + kCompactSlack;
    hasText_ = descriptor_ < 0 ? create() && append(bytes) : tooLarge ? compact(entry) : append(bytes);
    failed_ = failed_ && !hasText_;
}

bool RecoveryJournal::create() {
    std::error_code failed;
    std::filesystem::create_directories(folder_, failed);
    const std::string stem = std::to_string(processNumber());
    static std::atomic<unsigned> created = 0; // journals of several documents are created at the same time
    const std::filesystem::path temporary = folder_ / (stem + '.' + std::to_string(++created) + ".new");
    const FileHandle descriptor = createLocked(temporary);
    if (descriptor < 0) {
        fail(std::strerror(errno));
        return false;
    }
    // Lock before naming the file, so that another program sees only locked journals and orphans.
    std::filesystem::path file;
    std::error_code linked = std::make_error_code(std::errc::file_exists);
    for (int k = 0; k < 10000 && linked == std::errc::file_exists; ++k) {
        file = folder_ / (stem + '-' + std::to_string(k) + ".journal");
        std::filesystem::create_hard_link(temporary, file, linked);
    }
    std::filesystem::remove(temporary, failed);
    if (linked) {
        fail(linked.message());
        closeFile(descriptor);
        return false;
    }
    descriptor_ = descriptor;
    size_ = 0;
    const std::lock_guard lock(mutex_);
    file_ = file;
    return true;
}

bool RecoveryJournal::append(const std::string &bytes) {
    const std::string whole = size_ == 0 ? std::string(kJournalMagic) + bytes : bytes;
    if (!writeAll(descriptor_, whole)) {
        fail(std::strerror(errno));
        // A partial record would hide all that follow, so return to the end of the last complete one.
        if (!cutFile(descriptor_, size_)) {
            fail(std::strerror(errno));
        }
        return false;
    }
    size_ += whole.size();
    return true;
}

bool RecoveryJournal::compact(const Entry &entry) {
    std::filesystem::path temporary = file_;
    temporary.replace_extension(".new");
    const std::string bytes =
        std::string(kJournalMagic) + placeRecords(entry.place) + encodeRecord(JournalRecord::FullText, text_);
    const FileHandle descriptor = createLocked(temporary);
    if (descriptor < 0 || !writeAll(descriptor, bytes)) {
        fail(std::strerror(errno));
        abandon(temporary, descriptor);
        return false;
    }
    std::error_code failed;
    std::filesystem::rename(temporary, file_, failed);
    if (failed) {
        fail(failed.message());
        abandon(temporary, descriptor);
        return false;
    }
    closeFile(std::exchange(descriptor_, descriptor));
    size_ = bytes.size();
    return true;
}

void RecoveryJournal::fail(const std::string &what) {
    if (std::exchange(failed_, true)) {
        return;
    }
    Diagnostics fault =
        error("journal-failed", "cannot write the recovery journal in " + folder_.string() + ": " + what,
              "save the document; a crash would lose unsaved changes");
    fault.front().severity = Severity::Warning;
    const std::lock_guard lock(mutex_);
    faults_.insert(faults_.end(), fault.begin(), fault.end());
}

} // namespace forefront
