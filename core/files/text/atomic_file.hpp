#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/text/text_writer.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace FOREFRONT_API forefront {

/// A file that appears under its name only when it is complete: bytes go to a temporary file in the same folder, which
/// commit() flushes to the disc and renames. Destroyed without commit, it leaves nothing behind. A link is followed,
/// also one whose target does not exist yet; a device or pipe is written directly; a write-protected file is refused.
/// Temporary files for the same name that killed programs have left behind are removed.
class AtomicFile final : public ByteSink {
  public:
    /// `expectedBytes` scales the reported progress; 0: no progress.
    explicit AtomicFile(const std::filesystem::path &path, const Progress &progress = {},
                        std::size_t expectedBytes = 0);
    ~AtomicFile() override;
    AtomicFile(const AtomicFile &) = delete;
    AtomicFile &operator=(const AtomicFile &) = delete;

    bool write(std::string_view bytes) override;
    /// Flushes and renames the file. Faults: cannot-write with path and the text of errno, cancelled.
    Status commit();

    // The steps of a commit, for a set of files of which none may be replaced before all are complete: see FileSet.

    /// Flushes the complete file to the disc. Faults as for commit().
    Status finish();
    /// Gives the finished file its name. Keeps the file that had it until release(), where the file system can. Faults
    /// as for commit().
    Status publish();
    /// Undoes publish().
    void withdraw();
    /// Drops the file that publish() replaced.
    void release();
    /// Returns the file that is written, behind links.
    const std::filesystem::path &target() const { return target_; }

  private:
    void openDirectly();
    void fail(const std::string &action, int number);

    std::filesystem::path path_;
    std::filesystem::path target_;
    std::string temporary_; ///< empty: written directly, or already renamed
    std::string previous_;  ///< another name of the file that publish() replaced; empty: none
    bool published_ = false;
    Progress progress_;
    std::size_t expectedBytes_;
    std::size_t written_ = 0;
    int descriptor_ = -1;
    Status status_;
};

/// Returns why a file cannot be replaced although its folder allows it: it is write-protected. Empty for other files
/// and those that do not exist. The fault does not name the file.
Status checkReplaceable(const std::filesystem::path &path);

/// Writes one file through `fill`, atomically.
Status writeTextFile(const std::filesystem::path &path, const std::function<void(TextWriter &)> &fill,
                     const Progress &progress = {}, std::size_t expectedBytes = 0);

/// Writes bytes atomically: to a temporary file in the same folder, which is flushed and renamed.
Status writeFileAtomically(const std::filesystem::path &path, std::string_view bytes);

} // namespace forefront
