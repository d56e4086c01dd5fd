#pragma once

#include "core/base/result.hpp"
#include "core/edit/document.hpp"

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

/// $XDG_STATE_HOME/forefront, or ~/.local/state/forefront; where there is no home, a folder among the temporary files.
std::filesystem::path stateFolder();

/// Keeps the open document safe from a crash. Every change handed to record() is in a file within a second, appended
/// by a thread of its own as the difference to the text before; kill -9 loses no more than that. The file is locked
/// while the program lives, so that another one never takes it for an orphan, and removed when the journal is
/// destroyed. Nothing is written before the first change.
class RecoveryJournal {
  public:
    using Serialise = std::function<std::string(const Document &)>;

    /// `serialise` gives the text of a document (projectText); it is called on the journal's thread.
    RecoveryJournal(std::filesystem::path folder, Serialise serialise);
    ~RecoveryJournal();
    RecoveryJournal(const RecoveryJournal &) = delete;
    RecoveryJournal &operator=(const RecoveryJournal &) = delete;

    /// The document as it is now, and where it is saved (empty: nowhere). Returns at once.
    void record(std::shared_ptr<const Document> document, std::filesystem::path savedAt);
    /// The document is what its file holds, or was given up: there is nothing to recover until the next record().
    void recordSaved();
    /// Waits until everything recorded is on the disc.
    void flush();
    /// What went wrong since the last call: code "journal-failed", at most once until writing works again.
    Diagnostics takeFaults();
    /// The journal file; empty before anything was written.
    std::filesystem::path file() const;

  private:
    struct Entry {
        std::shared_ptr<const Document> document; ///< null: saved
        std::filesystem::path savedAt;
    };
    void work(const std::stop_token &stop);
    void write(const Entry &entry);
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

    // The thread's own.
    int descriptor_ = -1;
    std::string text_; ///< as the journal says at its end
    std::filesystem::path savedAt_;
    bool hasText_ = false, failed_ = false;
    std::uint64_t size_ = 0;

    std::jthread thread_; ///< last: it uses all of the above
};

/// A journal whose program is gone. Holds its lock: no other program offers it meanwhile.
class OrphanedJournal {
  public:
    OrphanedJournal(std::filesystem::path file, int descriptor, std::string savedAt, std::string text,
                    std::time_t written);
    ~OrphanedJournal();
    OrphanedJournal(OrphanedJournal &&other) noexcept;
    OrphanedJournal &operator=(OrphanedJournal &&other) noexcept;

    const std::filesystem::path &file() const { return file_; }
    /// Where the document is saved; empty: it never was.
    const std::filesystem::path &savedAt() const { return savedAt_; }
    /// Text of the newest document.
    const std::string &text() const { return text_; }
    /// When it was written last.
    std::time_t written() const { return written_; }
    /// Removes the journal, once its document is safe elsewhere or not wanted.
    void discard();

  private:
    std::filesystem::path file_, savedAt_;
    int descriptor_ = -1;
    std::string text_;
    std::time_t written_ = 0;
};

/// Journals of programs that ended without cleaning up, newest first. Those with nothing to recover are removed.
std::vector<OrphanedJournal> findOrphanedJournals(const std::filesystem::path &folder);

} // namespace forefront
