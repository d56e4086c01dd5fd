#pragma once

#include "core/edit/recovery_journal.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace forefront {

struct AppContext;

/// Keeps the open document safe from a crash and offers what an earlier crash has left.
class Recovery {
  public:
    /// Journals stand in `folder`/recovery.
    explicit Recovery(const std::filesystem::path &folder);

    /// Asks about journals of programs that are gone, if there are any.
    void offer(AppContext &context);
    /// Hands the document to the journal where it has changed; once per frame.
    void follow(AppContext &context);
    /// Makes the document of a journal the open one, unsaved; the journal goes once it is safe in our own. False if it
    /// cannot be read.
    bool recover(OrphanedJournal &orphan, AppContext &context);

  private:
    std::filesystem::path folder_;
    RecoveryJournal journal_;
    std::uint64_t revision_ = 0;
    bool dirty_ = false;
};

} // namespace forefront
