#pragma once

#include "core/engine/base/result.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

struct FileFormat;

/// A kind of file that a file dialog offers.
struct FileFilter {
    std::string name;                    ///< "Projects"
    std::vector<std::string> extensions; ///< ".forefront", lower case; empty: every file
    std::string id;                      ///< identifies the filter to the caller
    std::string note{};                  ///< what such a file keeps; shown below its name
};

struct FileEntry {
    std::string name; ///< UTF-8
    bool folder = false;
    std::uintmax_t size = 0;
    std::int64_t modified = 0; ///< seconds since the epoch
};

/// Lists folders first, then files, each sorted by name without regard to case. Leaves out dot files and files that do
/// not pass the filter. Error: "folder" with the reason.
Result<std::vector<FileEntry>> listFolder(const std::filesystem::path &folder, const FileFilter &filter);

/// Returns the filters of an open dialog: all files that it can open, the given filters, one for each format that
/// `reads` accepts, and any file. `all`: name of the first filter, such as "All drawings".
std::vector<FileFilter> openFilters(std::string all, const std::vector<FileFilter> &given,
                                    const std::function<bool(const FileFormat &)> &reads);

/// Returns true if a file name passes the filter.
bool passes(const FileFilter &filter, std::string_view name);
/// Returns a fault if the extension of a new file's name belongs to no filter; empty if it is known or missing.
Diagnostics checkExtension(std::string_view name, const std::vector<FileFilter> &filters);
/// Adds the first extension of the filter to a name, unless the name already has one of the filter's extensions. An
/// extension of one of the `others` is replaced.
std::string withExtension(std::string name, const FileFilter &filter, const std::vector<FileFilter> &others);
/// Resolves a typed path: "~" and "~/..." from the home folder, relative paths from `folder`, "." and "..".
std::filesystem::path resolved(const std::filesystem::path &folder, std::string_view typed);
/// Formats a size as in "1.2 MB".
std::string fileSizeText(std::uintmax_t bytes);

} // namespace forefront
