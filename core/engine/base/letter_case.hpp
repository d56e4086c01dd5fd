#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace forefront {

/// Returns a text with its ASCII letters in lower case, independent of the locale.
inline std::string lowerCase(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
    return result;
}

/// Returns a text with its ASCII letters in upper case, independent of the locale.
inline std::string upperCase(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - ('a' - 'A')) : c; });
    return result;
}

} // namespace forefront
