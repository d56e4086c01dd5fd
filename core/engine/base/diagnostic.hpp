#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/vec2.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// Severity of a diagnostic.
enum class Severity : std::uint8_t { Error, Warning, Note };

/// Kind of a domain part.
enum class DomainPartKind : std::uint8_t { Node, Segment, ConstraintPoint, HoleMarker, RegionMarker };

/// A part of a domain that a diagnostic refers to.
struct DomainPart {
    DomainPartKind kind = DomainPartKind::Node;
    std::uint32_t index = 0; ///< into the domain's list of such parts
    /// Number in the domain's file, filled in by the reader; empty if unknown.
    std::optional<std::int64_t> number = {};
    int line = 0;   ///< in that file, 1-based; 0: unknown
    int column = 0; ///< in that line, 1-based; 0: unknown
};
inline DomainPart aNode(std::uint32_t index) {
    return {DomainPartKind::Node, index};
}
inline DomainPart aSegment(std::uint32_t index) {
    return {DomainPartKind::Segment, index};
}

/// A fault or remark: what is wrong, where, and how to fix it. Shown in the editor's log and on stderr, one per line.
struct Diagnostic {
    Severity severity = Severity::Error;
    /// Stable identifier for tests and scripts, such as "crossing-segments" or "bad-number".
    std::string code;
    /// What is wrong, with the value, and what was expected; lower case, without a full stop.
    std::string message;
    /// How to fix it; may be empty.
    std::string advice;
    /// Place in the domain, in domain units; the view can zoom to it.
    std::optional<Vec2> at;
    /// Parts of the domain involved; the message does not repeat their numbers.
    std::vector<DomainPart> parts;
    /// Zero-based indices of other items in the message, such as nodes and elements of a mesh.
    std::vector<std::uint32_t> ids;
    /// Place in a file: name, line and column (1-based; 0: unknown).
    std::string file;
    int line = 0;
    int column = 0;
};

using Diagnostics = std::vector<Diagnostic>;

/// The maximum number of faults that a check lists by default.
inline constexpr std::size_t kMaxListedFaults = 200;

/// Returns "FILE:LINE:COLUMN: error: MESSAGE at (X, Y): segment 3 (line 7) and node 5 (line 4) [code]; ADVICE" without
/// the parts that are unknown; one line, no newline.
std::string toString(const Diagnostic &diagnostic);

/// Returns true if any entry is an error.
bool hasErrors(const Diagnostics &diagnostics);

/// Returns true if any entry has that code.
bool hasCode(const Diagnostics &diagnostics, std::string_view code);

/// Returns a list that holds one error.
Diagnostics error(std::string code, std::string message, std::string advice = {});

} // namespace forefront
