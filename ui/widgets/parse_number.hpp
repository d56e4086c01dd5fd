#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace forefront {

/// Returns `text` without the spaces at both ends.
std::string_view trimmed(std::string_view text);
/// Parses a finite number. The entire text must be consumed, except for spaces around it.
std::optional<double> parseNumber(std::string_view text);
/// Returns the position of the comma that separates two numbers, not two arguments of a function; npos if there is
/// none.
std::size_t separatingComma(std::string_view text);

} // namespace forefront
