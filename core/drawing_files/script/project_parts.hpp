#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/json/json.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Returns the part of a JSON text that begins at the offset of a value and holds the whole value.
std::string_view textOf(std::string_view text, const JsonValue &value);

/// Reads a project that is a value inside a script. Faults: those of readProjectText(), with their places in the
/// script, and unknown-member for what a project file would only be noted for.
Result<Document> readProjectValue(const JsonValue &project, const SourceText &script);

/// The text of a project in parts that can be replaced one by one, each as JSON.
struct ProjectParts {
    struct ShapeText {
        std::uint32_t id = 0; ///< 0: it has none yet
        std::string text;
        std::optional<std::size_t> offset = {}; ///< in the script; absent: not from there
    };
    struct MemberText {
        std::string name;
        std::string text;
        std::optional<std::size_t> offset = {};
    };
    std::vector<ShapeText> shapes;
    std::vector<MemberText> members; ///< other than "shapes", in order

    /// Splits the text that projectText() returns for a document.
    static ProjectParts of(const Document &document);
    /// Returns the text of a member; empty if there is none.
    std::string_view member(std::string_view name) const;
    /// Sets or, with an empty text, removes a member.
    void set(MemberText given);
    /// Reads the project that the parts make. Shapes without an id get the next ones. Faults: as for
    /// readProjectValue(); those in parts that are not from the script have no place.
    Result<Document> read(const SourceText &script) const;
};

} // namespace forefront
