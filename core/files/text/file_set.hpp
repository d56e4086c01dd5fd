#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/text/text_writer.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

class AtomicFile;

/// Files that belong together: none of them is replaced before all are complete on the disc, and none at all if one
/// fails. Destroyed without commit, the set leaves nothing behind. Devices and pipes are written directly.
class FileSet {
  public:
    FileSet();
    ~FileSet();
    FileSet(const FileSet &) = delete;
    FileSet &operator=(const FileSet &) = delete;

    /// Writes a file through `fill`, without giving it its name yet. Does nothing after a fault. Returns false if there
    /// is a fault, which commit() returns. `expectedBytes`: as for AtomicFile.
    bool write(const std::filesystem::path &path, const std::function<void(TextWriter &)> &fill,
               const Progress &progress = {}, std::size_t expectedBytes = 0);
    bool write(const std::filesystem::path &path, std::string_view bytes);
    /// Makes a folder and those above it. A set destroyed without commit removes the ones that it made. Does nothing
    /// after a fault; returns false if there is one.
    bool makeFolder(const std::filesystem::path &folder);
    bool ok() const { return status_.empty(); }
    /// Returns the faults so far.
    const Status &status() const { return status_; }
    /// Gives all files their names. Faults: cannot-write, cancelled; no file is then replaced, as far as the file
    /// system can take back what it has renamed.
    Status commit();

  private:
    void removeFolders();

    std::vector<std::unique_ptr<AtomicFile>> files_;
    std::vector<std::filesystem::path> folders_; ///< made by this set, each after those that it lies in
    Status status_;
};

} // namespace forefront
