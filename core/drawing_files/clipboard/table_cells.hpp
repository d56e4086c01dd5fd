#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Returns the finite number in a cell of a table; none if there is none. The last point or comma is the decimal sign;
/// the other may separate thousands before it, groups of three digits.
std::optional<double> numberInCell(std::string_view cell);

/// What a comma in a number can be; either in "1,234".
enum class CommaUse : std::uint8_t { None, Decimal, Thousands, Either };

/// Returns what the comma in a cell with a number is.
CommaUse commaUse(std::string_view cell);

/// Returns a cell without blanks, quotes and brackets around it.
std::string_view trimmedCell(std::string_view cell);

/// Returns the cells of a line, trimmed: the parts between `separator`, or the words if it is a blank.
std::vector<std::string_view> cellsOf(std::string_view line, char separator);

} // namespace forefront
