#pragma once

#include "core/base/result.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// A kind of file offered in a file dialog.
struct FileFilter {
    std::string name;                    ///< "Projects"
    std::vector<std::string> extensions; ///< ".forefront", lower case; empty: every file
    std::string id;                      ///< what the caller knows it by
};

struct FileEntry {
    std::string name; ///< UTF-8
    bool folder = false;
    std::uintmax_t size = 0;
    std::int64_t modified = 0; ///< seconds since the epoch
};

/// Folders first, then files, each by name without regard to case. Dot files and files that do not pass the filter are
/// left out. Fault: "folder" with the reason.
Result<std::vector<FileEntry>> listFolder(const std::filesystem::path &folder, const FileFilter &filter);

/// True if the filter lets a file name through.
bool passes(const FileFilter &filter, std::string_view name);
/// The name with the first extension of the filter, unless it has one of the filter's already. `others`: extensions of
/// the other filters, which are replaced instead of kept.
std::string withExtension(std::string name, const FileFilter &filter, const std::vector<FileFilter> &others);
/// "~" and "~/..." spelt out, relative paths taken from `folder`, "." and ".." resolved.
std::filesystem::path resolved(const std::filesystem::path &folder, std::string_view typed);
/// "1.2 MB".
std::string fileSizeText(std::uintmax_t bytes);

} // namespace forefront
