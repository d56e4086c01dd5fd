#pragma once

#include <optional>
#include <string_view>

namespace forefront {

/// Returns `text` without the spaces at both ends.
std::string_view trimmed(std::string_view text);
/// Parses a finite number. The entire text must be consumed, except for spaces around it.
std::optional<double> parseNumber(std::string_view text);

} // namespace forefront
