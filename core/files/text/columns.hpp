#pragma once

#include "core/files/text/text_writer.hpp"

#include <array>
#include <charconv>
#include <concepts>
#include <cstddef>
#include <string_view>

namespace forefront {

/// Writes a number in a column, with blanks before it. `width`: of the column, at most 40; longer numbers exceed it.
template <std::integral Integer>
void writeColumn(TextWriter &out, Integer value, std::size_t width) {
    constexpr std::string_view kBlanks = "                                        ";
    std::array<char, 24> digits;
    const char *const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    const std::string_view text(digits.data(), static_cast<std::size_t>(end - digits.data()));
    out << kBlanks.substr(0, width > text.size() ? width - text.size() : 0) << text;
}

} // namespace forefront
