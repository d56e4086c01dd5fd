#pragma once

#include "core/geometry/vec2.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

enum class Severity : std::uint8_t { Error, Warning, Note };

/// What is wrong, where, and what to do. Shown in the log of the editor and on stderr, one a line.
struct Diagnostic {
    Severity severity = Severity::Error;
    /// Short stable identifier for tests and scripts, such as "crossing-segments" or "bad-number".
    std::string code;
    /// One sentence without a trailing full stop.
    std::string message;
    /// What the user can do about it; may be empty.
    std::string advice;
    /// Place in the domain, in domain units; the view can go there.
    std::optional<Vec2> at;
    /// Ids (zero-based indices of nodes or segments, as the message says) involved.
    std::vector<std::uint32_t> ids;
    /// Place in a file: name, line and column (1-based; 0: unknown).
    std::string file;
    int line = 0;
    int column = 0;
};

using Diagnostics = std::vector<Diagnostic>;

/// "FILE:LINE:COLUMN: error: MESSAGE at (X, Y) [code]; ADVICE", the parts that are known; one line, no newline.
std::string toString(const Diagnostic &diagnostic);

/// True if any entry is an error.
bool hasErrors(const Diagnostics &diagnostics);

/// A list that holds one error.
Diagnostics error(std::string code, std::string message, std::string advice = {});

} // namespace forefront
