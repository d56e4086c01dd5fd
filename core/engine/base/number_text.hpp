#pragma once

#include "core/engine/base/vec2.hpp"

#include <array>
#include <charconv>
#include <cstddef>
#include <string>

namespace forefront {

/// Returns a number with up to `digits` significant digits, as printf's %g writes it, for messages. Unlike printf,
/// std::to_chars does not depend on the locale, and it needs no other library.
inline std::string numberText(double value, int digits) {
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

/// Returns a number rounded to up to `digits` significant digits, for numbers that people read and edit: the double
/// nearest to the decimal number, so that it is also written with these digits.
inline double roundedTo(double value, int digits) {
    const std::string text = numberText(value, digits);
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

/// Returns the shortest text that is read as the same number.
inline std::string exactText(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end.ptr};
}

/// Returns a count with its noun, such as "1 node" or "3 nodes", for messages.
inline std::string countText(std::size_t count, const char *noun) {
    return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

/// Returns a position as "(1.5, 2)" with six significant digits, for messages.
inline std::string placeText(Vec2 place) {
    return '(' + numberText(place.x, 6) + ", " + numberText(place.y, 6) + ')';
}

} // namespace forefront
