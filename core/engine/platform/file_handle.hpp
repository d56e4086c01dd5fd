#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string_view>

namespace forefront {

// Files below the standard library: what it cannot do is to create a file only if it is new, to lock one, and to write
// it to the disk. Functions that fail set errno.

/// An open file, as the C library of the system numbers it; negative: none.
using FileHandle = int;

enum class FileAccess : std::uint8_t {
    Read,        ///< waits for the other end of a pipe
    ReadNow,     ///< does not wait
    Inspect,     ///< reads without following a link, and does not wait
    Change,      ///< reads and writes without following a link, and does not wait
    Write,       ///< writes an existing file or device
    Create,      ///< writes a new file; fails with EEXIST if there is one
    ReplaceOwned ///< reads and writes an empty file that only its owner may read
};

/// Opens a file; negative on failure. Programs that are started do not inherit it.
FileHandle openFile(const std::filesystem::path &path, FileAccess access);
/// Returns false if the last bytes could not be written.
bool closeFile(FileHandle file);
/// Returns a stream that reads a file as bytes, and closes it in the end; null on failure, which leaves it open.
std::FILE *streamOf(FileHandle file);
/// Reads up to `bytes`; 0 at the end, negative on failure, which may be EINTR.
std::ptrdiff_t readSome(FileHandle file, char *buffer, std::size_t bytes);
/// Writes up to all of the bytes; negative on failure, which may be EINTR.
std::ptrdiff_t writeSome(FileHandle file, std::string_view bytes);
/// Cuts a file after `size` bytes and continues to write there.
bool cutFile(FileHandle file, std::uint64_t size);
/// Waits until the content is on the disk. True for files that are on none.
bool syncFile(FileHandle file);
/// Waits until the names in a folder are on the disk, where the system can.
void syncFolder(const std::filesystem::path &folder);
/// Locks a file for this handle; false if another one holds it.
bool lockFile(FileHandle file);

struct FileStatus {
    enum class Kind : std::uint8_t { Regular, Folder, Terminal, Device, Other };
    Kind kind = Kind::Other;
    std::uint64_t size = 0;           ///< bytes
    std::uint64_t device = 0, id = 0; ///< together the identity of the file; 0 where the system has none
    std::int64_t modified = 0;        ///< nanoseconds since 1970
    unsigned permissions = 0;         ///< as of POSIX

    bool sameFile(const FileStatus &other) const { return device == other.device && id == other.id; }
};
/// Return false on failure.
bool statusOf(FileHandle file, FileStatus &status);
bool statusOf(const std::filesystem::path &path, FileStatus &status);

/// Gives a new file the permissions of the one that it will replace, where the system has them in this form.
void copyPermissions(FileHandle file, const FileStatus &from);
/// Returns true if the user may write a file, and it is not marked as write-protected, which does not bind the
/// superuser.
bool isWritable(const std::filesystem::path &path, const FileStatus &status);

/// The standard input and output of the program as files.
inline constexpr FileHandle kStandardInput = 0, kStandardOutput = 1;
/// Makes standard input and output transport bytes unchanged. Needed where texts are translated.
void useBinaryStandardStreams();
/// Returns true if the standard error stream is shown to a person.
bool errorsGoToTerminal();

} // namespace forefront
