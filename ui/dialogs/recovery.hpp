#pragma once

#include "core/drawing/recovery/recovery_journal.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace forefront {

struct Shell;

/// Journals the open document and offers to recover what a crash left behind.
class Recovery {
  public:
    /// Stores the journals in `folder`/recovery.
    explicit Recovery(const std::filesystem::path &folder);

    /// Opens the recovery dialog if programs that crashed left journals.
    void offer(Shell &context);
    /// Records the document in the journal if it has changed. Called once per frame.
    void follow(Shell &context);
    /// Opens the document of a journal as unsaved, and removes that journal once the document is in the current one.
    /// Returns false if the journal cannot be read.
    bool recover(OrphanedJournal &orphan, Shell &context);

  private:
    std::filesystem::path folder_;
    RecoveryJournal journal_;
    std::uint64_t revision_ = 0;
    bool dirty_ = false;
};

} // namespace forefront
