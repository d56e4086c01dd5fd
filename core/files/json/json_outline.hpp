#pragma once

#include <string_view>
#include <vector>

namespace forefront {

/// The members at the top of a JSON object, as far as they are needed to recognise its format.
struct JsonOutline {
    std::string_view type;              ///< value of the member "type" if that is a string; else empty
    std::vector<std::string_view> keys; ///< the members before that, the first few; as written, without quotes
    bool ends = false;                  ///< the object ends within the text, without such a member

    bool has(std::string_view key) const;
};

/// Reads the outline of an object without parsing the values of its members. The text may be cut off anywhere, or be no
/// JSON at all: then the outline is empty. Views point into the text.
JsonOutline outlineOf(std::string_view text);

/// Returns true if a text begins as a JSON object does, after blanks, a record separator or a byte order mark.
bool beginsAsObject(std::string_view text);

} // namespace forefront
