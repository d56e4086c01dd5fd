#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace forefront {

/// A fingerprint of a file at one moment, to find out later whether another program has changed it.
struct FileStamp {
    enum class Kind : std::uint8_t {
        Unknown, ///< never looked at, or it cannot be read at the moment
        Missing,
        File
    };
    Kind kind = Kind::Unknown;
    std::uint64_t hash = 0; ///< of the content

    // Cheap signs that the content is still the same; all 0 if they are unknown.
    std::uint64_t size = 0, device = 0, inode = 0;
    std::int64_t modified = 0; ///< nanoseconds since 1970
    /// The file was last modified long enough before it was looked at that any later change shows in `modified`, which
    /// some file systems keep in steps of two seconds.
    bool settled = false;

    bool known() const { return kind != Kind::Unknown; }
    bool sameContent(const FileStamp &other) const { return kind == other.kind && hash == other.hash; }
};

/// Returns the stamp of a file. Reads its content only if size, time or inode differ from `before`. Follows links.
/// Unknown for pipes, devices and folders.
FileStamp stampOf(const std::filesystem::path &file, const FileStamp &before = {});

/// Returns the stamp of a file with this content, of which nothing else is known.
FileStamp stampOfContent(std::string_view content);

} // namespace forefront
