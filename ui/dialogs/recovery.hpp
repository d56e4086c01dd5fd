#pragma once

#include "core/drawing/document/shape.hpp"
#include "core/drawing/recovery/recovery_journal.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

struct Shell;

/// Journals the open document and offers to recover what a crash left behind.
class Recovery {
  public:
    /// Stores the journals in `folder`/recovery.
    explicit Recovery(const std::filesystem::path &folder);

    /// Opens the recovery dialog if programs that crashed left journals. Until they are recovered or discarded, the
    /// start page lists their drawings, too: Shell::unsaved.
    void offer(Shell &context);
    /// Records the document in the journal if it has changed, with the path that is being drawn. Called once per frame.
    void follow(Shell &context);

    /// A journal that was left behind.
    struct Orphan {
        OrphanedJournal journal;
        std::string name;    ///< of its file, or its title
        std::string details; ///< number of shapes, time of the last change
    };
    const std::vector<Orphan> &orphans() const { return orphans_; }
    /// Opens the document of a journal as unsaved, and removes that journal once the document is in the current one.
    /// Returns false if the journal cannot be read.
    bool recover(std::size_t orphan, Shell &context);
    /// Removes a journal and what it keeps.
    void discard(std::size_t orphan, Shell &context);

  private:
    std::size_t collect(Shell &context);
    void lookAgain(Shell &context);
    void publish(Shell &context);

    std::filesystem::path folder_;
    RecoveryJournal journal_;
    std::vector<Orphan> orphans_;
    std::uint64_t revision_ = 0;
    bool dirty_ = false;
    std::optional<Shape> path_;              ///< the unfinished path that is recorded with the document
    double nextLook_ = 0.0, lastLook_ = 0.0; ///< for journals that were locked at the start, seconds
};

} // namespace forefront
