#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/json/json.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

/// Returns the part of a JSON text that begins at the offset of a value and holds the whole value.
std::string_view textOf(std::string_view text, const JsonValue &value);

/// The text of a project in parts that can be replaced one by one, each as JSON.
struct ProjectParts {
    struct ShapeText {
        std::uint32_t id = 0; ///< 0: it has none yet
        std::string text;
    };
    std::vector<ShapeText> shapes;
    std::vector<std::pair<std::string, std::string>> members; ///< other than "shapes", in order

    /// Splits the text that projectText() returns for a document.
    static ProjectParts of(const Document &document);
    /// Returns the text of a member; empty if there is none.
    std::string_view member(std::string_view name) const;
    /// Sets or, with an empty text, removes a member.
    void set(std::string_view name, std::string text);
    /// Reads the project that the parts make. Shapes without an id get the next ones. Faults: those of parseProject(),
    /// without a place.
    Result<Document> read() const;
};

} // namespace forefront
