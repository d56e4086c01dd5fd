#pragma once

#include "core/base/result.hpp"
#include "core/io/domain_origin.hpp"
#include "core/io/files.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace forefront {

/// The bytes of an input file and where they come from. Readers work on this alone, so that tests and fuzzers feed them
/// from memory; `path` is empty there and companion files (.node beside .poly) are then out of reach.
struct SourceText {
    std::string_view text;
    std::string name;           ///< as shown in messages
    std::filesystem::path path; ///< of the file itself, for finding its companions; may be empty
    ImportOptions options;
    DomainOrigin *origin = nullptr; ///< where a reader of domains shall note the places of the parts; null: nowhere
};

/// 1-based line and column (in bytes) of a byte of a text.
struct TextPlace {
    int line = 1;
    int column = 1;
};
TextPlace placeOf(std::string_view text, std::size_t offset);

/// One error that carries file, line and column of `offset`.
Diagnostic faultAt(const SourceText &source, std::size_t offset, std::string code, std::string message,
                   std::string advice = {});

/// A token as quoted in a message: printable, shortened.
std::string inQuotes(std::string_view token);

/// The whole content of a file, without the byte order mark that some editors put before UTF-8; faults: cannot-read
/// with the text of errno, too-large.
Result<std::string> readFileBytes(const std::filesystem::path &path, std::size_t maxBytes);

} // namespace forefront
