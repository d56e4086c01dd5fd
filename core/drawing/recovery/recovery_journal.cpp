#include "core/drawing/recovery/recovery_journal.hpp"

#include "core/drawing/recovery/journal_record.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace forefront {
namespace {

using namespace std::chrono_literals;

/// Minimum and maximum time between two writes; slow writes are followed by longer pauses.
constexpr auto kShortestRest = 200ms;
constexpr auto kLongestRest = 700ms;
/// A journal is rewritten when it exceeds the text of its document by this factor.
constexpr std::uint64_t kCompactFactor = 4, kCompactSlack = 1U << 20;

bool writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0) {
            if (errno == EINTR) {
                continue;
            }
            return false;
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return ::fdatasync(descriptor) == 0 || errno == EINVAL;
}

/// Creates a locked file that findOrphanedJournals() does not see yet. Returns -1 and sets errno on failure.
int createLocked(const std::filesystem::path &path) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (descriptor >= 0 && ::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        ::close(descriptor);
        return -1;
    }
    return descriptor;
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
    return (failed ? std::filesystem::path("/tmp") : temporary) / ("forefront-" + std::to_string(::getuid()));
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
        ::close(descriptor_);
    }
}

void RecoveryJournal::record(std::shared_ptr<const Document> document, Place place) {
    const std::lock_guard lock(mutex_);
    pending_ = std::make_unique<Entry>(Entry{std::move(document), std::move(place)});
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
    if (entry.document == nullptr) {
        if (hasText_ && append(encodeRecord(JournalRecord::Saved, {}))) {
            failed_ = false;
        }
        return;
    }
    std::string text;
    try {
        text = serialise_(*entry.document);
    } catch (const std::exception &exception) {
        fail(exception.what());
        return;
    }
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
    const std::string stem = std::to_string(::getpid());
    const std::filesystem::path temporary = folder_ / (stem + ".new");
    const int descriptor = createLocked(temporary);
    if (descriptor < 0) {
        fail(std::strerror(errno));
        return false;
    }
    // Lock before naming the file, so that another program sees only locked journals and orphans.
    std::filesystem::path file;
    int linked = -1;
    for (int k = 0; k < 10000 && linked != 0; ++k) {
        file = folder_ / (stem + '-' + std::to_string(k) + ".journal");
        linked = ::link(temporary.c_str(), file.c_str());
        if (linked != 0 && errno != EEXIST) {
            break;
        }
    }
    const int reason = errno;
    ::unlink(temporary.c_str());
    if (linked != 0) {
        fail(std::strerror(reason));
        ::close(descriptor);
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
        if (::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0 ||
            ::lseek(descriptor_, static_cast<off_t>(size_), SEEK_SET) < 0) {
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
    const int descriptor = createLocked(temporary);
    if (descriptor < 0 || !writeAll(descriptor, bytes) || ::rename(temporary.c_str(), file_.c_str()) != 0) {
        fail(std::strerror(errno));
        if (descriptor >= 0) {
            ::unlink(temporary.c_str());
            ::close(descriptor);
        }
        return false;
    }
    ::close(std::exchange(descriptor_, descriptor));
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
