#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// A value that a text names: {word} or, within a formula, \value{word}.
struct NamedValue {
    std::size_t begin = 0, end = 0; ///< in the text, in bytes
    std::string_view word;          ///< of the text
    bool closed = true;             ///< false: the closing brace is missing
    bool inFormula = false;
};

/// Returns the values that a text names, in order. Other braces in formulas are TeX's.
std::vector<NamedValue> valuesNamed(std::string_view text);

/// Returns a text in which values are replaced by what `number` returns for their words; those for which it returns
/// nothing stay as they are. In a formula, 1e-05 becomes a power of 10.
std::string withValuesReplaced(std::string_view text,
                               const std::function<std::optional<std::string>(std::string_view word)> &number);

} // namespace forefront
