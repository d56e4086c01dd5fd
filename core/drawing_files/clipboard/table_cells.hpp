#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// Returns the finite number in a cell of a table; none if there is none. The last point or comma is the decimal sign;
/// the other may separate thousands before it.
std::optional<double> numberInCell(std::string_view cell);

/// Returns a cell without blanks, quotes and brackets around it.
std::string_view trimmedCell(std::string_view cell);

/// Returns the cells of a line, trimmed: the parts between `separator`, or the words if it is a blank.
std::vector<std::string_view> cellsOf(std::string_view line, char separator);

} // namespace forefront
