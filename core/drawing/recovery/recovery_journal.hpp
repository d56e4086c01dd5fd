#pragma once

#include "core/drawing/document/document.hpp"
#include "core/drawing/recovery/journal_record.hpp"
#include "core/engine/base/result.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace forefront {

/// Returns $XDG_STATE_HOME/forefront, or ~/.local/state/forefront; without a home directory, a temporary folder.
std::filesystem::path stateFolder();

/// Protects the open document against a crash. Every change passed to record() is written within a second, by a
/// separate thread, as a difference to the previous text; a crash loses at most that second. The file is locked while
/// the program runs, so that another instance does not take it for an orphan, and removed when the journal is
/// destroyed. Nothing is written before the first change.
class RecoveryJournal {
  public:
    using Serialise = std::function<std::string(const Document &)>;

    /// `serialise` returns the text of a document (projectText); it is called on the journal's thread.
    RecoveryJournal(std::filesystem::path folder, Serialise serialise);
    ~RecoveryJournal();
    RecoveryJournal(const RecoveryJournal &) = delete;
    RecoveryJournal &operator=(const RecoveryJournal &) = delete;

    /// Where a document belongs.
    struct Place {
        std::filesystem::path savedAt; ///< empty: never saved
        std::string title;
        std::uint64_t savedHash = 0; ///< of the file at `savedAt`; 0: unknown
        friend bool operator==(const Place &, const Place &) = default;
    };
    /// Returns a document; called on the journal's thread, and only for a change that it writes.
    using Make = std::function<std::shared_ptr<const Document>()>;
    /// Records the current document and its place. Returns immediately.
    void record(std::shared_ptr<const Document> document, Place place);
    /// Does the same for a document that takes time to make.
    void record(Make make, Place place);
    /// Records that the document was saved or discarded: there is nothing to recover until the next record().
    void recordSaved();
    /// Waits until everything recorded is on disk.
    void flush();
    /// Returns true if everything recorded is on disk. Destruction then waits for nothing.
    bool resting() const;
    /// Returns the faults since the last call: code "journal-failed", at most once until writing works again.
    Diagnostics takeFaults();
    /// Returns the path of the journal file; empty before anything was written.
    std::filesystem::path file() const;

  private:
    struct Entry {
        Make document; ///< empty: saved
        Place place;
    };
    void work(const std::stop_token &stop);
    static std::string placeRecords(const Place &place);
    void write(const Entry &entry);
    void writeText(const Entry &entry, std::string text);
    bool create();
    bool append(const std::string &bytes);
    bool compact(const Entry &entry);
    void fail(const std::string &what);

    const std::filesystem::path folder_;
    const Serialise serialise_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::unique_ptr<Entry> pending_;
    bool writing_ = false;
    bool urgent_ = false;
    Diagnostics faults_;
    std::filesystem::path file_;

    // Used only by the thread.
    int descriptor_ = -1;
    std::string text_; ///< the text that the journal encodes
    Place place_;
    bool hasText_ = false, failed_ = false;
    std::uint64_t size_ = 0;

    std::jthread thread_; ///< last: it uses all of the above
};

/// A journal whose program has ended. Holds its lock, so that no other program offers it.
class OrphanedJournal {
  public:
    OrphanedJournal(std::filesystem::path file, int descriptor, JournalContent content, std::time_t written);
    ~OrphanedJournal();
    OrphanedJournal(OrphanedJournal &&other) noexcept;
    OrphanedJournal &operator=(OrphanedJournal &&other) noexcept;

    const std::filesystem::path &file() const { return file_; }
    /// Returns the path the document was saved at; empty if never.
    const std::filesystem::path &savedAt() const { return savedAt_; }
    /// Returns the title of the document; empty if it had none.
    const std::string &title() const { return title_; }
    /// Returns the hash of the file at savedAt() when it was last read or saved; 0: unknown.
    std::uint64_t savedHash() const { return savedHash_; }
    /// Returns the text of the newest document.
    const std::string &text() const { return text_; }
    /// Returns the time of the last write.
    std::time_t written() const { return written_; }
    /// Removes the journal, once its document is saved elsewhere or no longer needed.
    void discard();

  private:
    std::filesystem::path file_, savedAt_;
    int descriptor_ = -1;
    std::string title_, text_;
    std::uint64_t savedHash_ = 0;
    std::time_t written_ = 0;
};

/// Finds the journals of programs that ended without cleaning up, newest first. Removes those with nothing to recover.
/// `locked`: set to the number of journals that others hold, programs that run or are still ending; may be null.
std::vector<OrphanedJournal> findOrphanedJournals(const std::filesystem::path &folder, std::size_t *locked = nullptr);

} // namespace forefront
