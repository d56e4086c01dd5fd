#pragma once

#include "core/drawing/document/shape.hpp"
#include "core/drawing/recovery/recovery_journal.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace forefront {

struct Document;
struct Shell;

/// Journals the open documents and offers to recover what a crash left behind.
class Recovery {
  public:
    /// Stores the journals in `folder`/recovery.
    explicit Recovery(const std::filesystem::path &folder);

    /// Opens the recovery dialog if programs that crashed left journals. Until they are recovered or discarded, the
    /// start page lists their drawings, too: Shell::unsaved.
    void offer(Shell &context);
    /// Records the document of each tab in its journal if it has changed, with the path that is being drawn. Called
    /// once per frame.
    void follow(Shell &context);

    /// A journal that was left behind.
    struct Orphan {
        OrphanedJournal journal;
        std::string name;    ///< of its file, or its title
        std::string details; ///< number of shapes, time of the last change
    };
    const std::vector<Orphan> &orphans() const { return orphans_; }
    /// Opens the document of a journal as unsaved, and removes that journal once the document is in a current one. It
    /// takes the place of the document of the same file if that has no changes, else it gets a tab. Returns false if
    /// the journal cannot be read.
    bool recover(std::size_t orphan, Shell &context);
    /// Recovers all documents that can be read. Returns true if none is left.
    bool recoverAll(Shell &context);
    /// Removes a journal and what it keeps.
    void discard(std::size_t orphan, Shell &context);

  private:
    /// The journal of a tab, and what was recorded last.
    struct Journalled {
        explicit Journalled(const std::filesystem::path &folder);
        RecoveryJournal journal;
        std::uint64_t revision = 0;
        bool dirty = false;
        std::optional<Shape> path; ///< the unfinished path that is recorded with the document
    };
    /// A document as it is now.
    struct Now {
        std::shared_ptr<const Document> document;
        std::uint64_t revision = 0;
        bool dirty = false;
        std::optional<Shape> path; ///< that is being drawn
        RecoveryJournal::Place place;
    };
    static Now documentOf(const Shell &context, std::size_t tab);
    void record(std::uint64_t tab, Now now);
    void close(const std::set<std::uint64_t> &open);
    void makeRoom(const OrphanedJournal &journal, Shell &context);
    std::size_t collect(Shell &context);
    void lookAgain(Shell &context);
    void publish(Shell &context);

    std::filesystem::path folder_;
    using Journals = std::map<std::uint64_t, Journalled>;
    Journals journals_;                       ///< by the id of the tab, once its document was changed
    std::vector<Journals::node_type> closed_; ///< of tabs that were closed, until they are written and removed
    std::vector<Orphan> orphans_;
    double nextLook_ = 0.0, lastLook_ = 0.0; ///< for journals that were locked at the start, seconds
};

} // namespace forefront
