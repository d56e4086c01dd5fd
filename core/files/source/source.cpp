#include "core/files/source/source.hpp"

#include "core/engine/base/cancelled.hpp"
#include "core/engine/platform/file_handle.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace forefront {

TextPlace placeOf(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const std::size_t lastBreak = before.rfind('\n');
    const std::size_t column = lastBreak == std::string_view::npos ? before.size() : before.size() - lastBreak - 1;
    return {static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1, static_cast<int>(column) + 1};
}

Diagnostic faultAt(const SourceText &source, std::size_t offset, std::string code, std::string message,
                   std::string advice) {
    Diagnostic fault = error(std::move(code), std::move(message), std::move(advice)).front();
    const TextPlace place = placeOf(source.text, offset);
    fault.file = source.name;
    fault.line = place.line;
    fault.column = place.column;
    return fault;
}

std::string inQuotes(std::string_view token) {
    constexpr std::size_t kLongest = 40;
    std::string text = "'";
    for (const char c : token.substr(0, kLongest)) {
        text += c >= ' ' && c <= '~' ? c : '?';
    }
    text += token.size() > kLongest ? "...'" : "'";
    return text;
}

namespace {

Diagnostics readFault(const std::string &name, const std::string &why) {
    Diagnostics faults = error("cannot-read", "cannot read the file: " + why);
    faults.front().file = name;
    return faults;
}

class OpenFile {
  public:
    explicit OpenFile(const std::filesystem::path &path, FileAccess access = FileAccess::Read)
        : handle_(openFile(path, access)) {}
    ~OpenFile() {
        if (handle_ >= 0) {
            closeFile(handle_);
        }
    }
    OpenFile(const OpenFile &) = delete;
    OpenFile &operator=(const OpenFile &) = delete;
    FileHandle handle() const { return handle_; }

  private:
    FileHandle handle_;
};

/// Reads an open file up to its end; `name` appears in faults.
Result<std::string> readHandle(FileHandle file, const std::string &name, std::size_t maxBytes,
                               const Progress &progress) {
    FileStatus status;
    if (file < 0 || !statusOf(file, status)) {
        return readFault(name, std::strerror(errno));
    }
    if (status.kind == FileStatus::Kind::Folder) {
        return readFault(name, "it is a folder");
    }
    // A device such as /dev/zero may have no end; a terminal has one, and /dev/null is empty.
    const bool device = status.kind == FileStatus::Kind::Device;
    const auto tooLarge = [&] {
        Diagnostics faults = error("too-large", "the file is larger than " + std::to_string(maxBytes) + " bytes");
        faults.front().file = name;
        return faults;
    };
    if (status.size > maxBytes) {
        return tooLarge();
    }
    constexpr std::size_t kChunk = std::size_t{1} << 20, kStopInterval = 16 * kChunk;
    std::string bytes;
    std::size_t size = 0;
    const bool regular = status.kind == FileStatus::Kind::Regular;
    bytes.resize(regular ? static_cast<std::size_t>(status.size) + 1 : kChunk);
    while (true) {
        if (progress.cancelled()) {
            return cancelled("reading");
        }
        const std::ptrdiff_t got = readSome(file, bytes.data() + size, std::min(bytes.size() - size, kStopInterval));
        if (got < 0) {
            if (errno == EINTR) {
                continue;
            }
            return readFault(name, std::strerror(errno));
        }
        if (got == 0) {
            break;
        }
        if (device) {
            return readFault(name, "it is a device, not a file");
        }
        size += static_cast<std::size_t>(got);
        if (size > maxBytes) {
            return tooLarge();
        }
        if (size == bytes.size()) {
            bytes.resize(size + std::max(kChunk, size / 2));
        }
    }
    bytes.resize(size);
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF"; // UTF-8; no binary format begins with it
    if (bytes.starts_with(kByteOrderMark)) {
        bytes.erase(0, kByteOrderMark.size());
    }
    return bytes;
}

} // namespace

Result<std::string> readFileBytes(const std::filesystem::path &path, std::size_t maxBytes, const Progress &progress) {
    if (progress.cancelled()) {
        return cancelled("reading"); // opening a pipe waits for its other end
    }
    const OpenFile file(path);
    return readHandle(file.handle(), path.string(), maxBytes, progress);
}

Status notRegular(const std::filesystem::path &path) {
    std::error_code none;
    const auto kind = std::filesystem::status(path, none).type();
    const bool other = kind == std::filesystem::file_type::fifo || kind == std::filesystem::file_type::socket ||
                       kind == std::filesystem::file_type::character || kind == std::filesystem::file_type::block;
    if (!other) {
        return {};
    }
    const bool device = kind == std::filesystem::file_type::character || kind == std::filesystem::file_type::block;
    return readFault(path.string(), device ? "it is a device; expected a regular file"
                                           : "it is a pipe or socket; expected a regular file");
}

Result<std::string> readRegularFile(const std::filesystem::path &path, std::size_t maxBytes, const Progress &progress) {
    if (Status fault = notRegular(path); !fault.empty()) {
        return fault;
    }
    const OpenFile file(path, FileAccess::ReadNow); // does not wait if it has become a pipe meanwhile
    return readHandle(file.handle(), path.string(), maxBytes, progress);
}

Result<std::string> readStandardInput(std::size_t maxBytes) {
    return readHandle(kStandardInput, "standard input", maxBytes, {});
}

} // namespace forefront
