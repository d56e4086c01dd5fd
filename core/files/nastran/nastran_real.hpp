#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace forefront {

/// The text of a real number in a field.
struct NastranReal {
    std::string text;
    bool rounded = false; ///< it does not read back to the same bits
};

/// Writes a real number with a decimal point in at most `width` characters, with as many digits as fit. `width`: 12 or
/// more.
NastranReal nastranReal(double value, std::size_t width);

/// Reads a real number, also such as 1.5-3, where Nastran allows to leave out the E of the exponent.
std::optional<double> readNastranReal(std::string_view text);

} // namespace forefront
