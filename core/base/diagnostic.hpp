#pragma once

#include "core/base/vec2.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

enum class Severity : std::uint8_t { Error, Warning, Note };

enum class DomainPartKind : std::uint8_t { Node, Segment, ConstraintPoint, HoleMarker, RegionMarker };

/// A part of a domain that a diagnostic speaks of.
struct DomainPart {
    DomainPartKind kind = DomainPartKind::Node;
    std::uint32_t index = 0; ///< in the domain's list of such parts
    /// As the file of the domain has it, filled in by its reader: the number there, and line and column (1-based). What
    /// is not known stays empty or 0.
    std::optional<std::int64_t> number = {};
    int line = 0;
    int column = 0;
};
inline DomainPart aNode(std::uint32_t index) {
    return {DomainPartKind::Node, index};
}
inline DomainPart aSegment(std::uint32_t index) {
    return {DomainPartKind::Segment, index};
}

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
    /// Parts of the domain involved; the message does not number them.
    std::vector<DomainPart> parts;
    /// Indices (zero-based) of what else the message numbers, such as nodes and elements of a mesh.
    std::vector<std::uint32_t> ids;
    /// Place in a file: name, line and column (1-based; 0: unknown).
    std::string file;
    int line = 0;
    int column = 0;
};

using Diagnostics = std::vector<Diagnostic>;

/// "FILE:LINE:COLUMN: error: MESSAGE at (X, Y): segment 3 (line 7) and node 5 (line 4) [code]; ADVICE", as far as it is
/// known; one line, no newline.
std::string toString(const Diagnostic &diagnostic);

/// True if any entry is an error.
bool hasErrors(const Diagnostics &diagnostics);

/// A list that holds one error.
Diagnostics error(std::string code, std::string message, std::string advice = {});

} // namespace forefront
