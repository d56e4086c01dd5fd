#pragma once

#include <string_view>

namespace forefront {

/// The properties of a colour that masks and opacity depend on.
struct SvgColour {
    double luminance = 0.0; ///< from 0 (black) to 1 (white)
    double alpha = 1.0;
    bool plain = true; ///< false for gradients and patterns, which have no single luminance
};

/// Reads a colour in lower case: #rgb and its longer forms, rgb(), rgba(), hsl(), hsla(), currentcolor, and names, of
/// which only dark ones matter. Anything unknown counts as white. `current`: the property `color`.
SvgColour parseColour(std::string_view text, const SvgColour &current);

/// Returns true if a value in lower case is valid for `fill` and `stroke`: "none", a colour, a reference or a word such
/// as "inherit". CSS ignores declarations with others. Of functions, only the name is checked.
bool isPaint(std::string_view text);

/// Reads an opacity: a number or a percentage, limited to 0 to 1; 1 if malformed.
double parseOpacity(std::string_view text);

} // namespace forefront
