#include "core/engine/base/number_text.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <string>
#include <string_view>

namespace forefront::ui {

namespace {

std::string groupedDigits(std::string_view digits) {
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) {
            text += "\xe2\x80\xaf"; // narrow no-break space
        }
        text += digits[i];
    }
    return text;
}

} // namespace

std::string count(std::uint64_t value) {
    return groupedDigits(std::to_string(value));
}

std::string format(const char *pattern, ...) {
    va_list arguments;
    va_start(arguments, pattern);
    char buffer[512];
    std::vsnprintf(buffer, sizeof buffer, pattern, arguments);
    va_end(arguments);
    return buffer;
}

std::string number(double value, int digits) {
    value += 0.0; // no negative zero
    const double size = std::abs(value);
    if (!(size >= 1e-4 && size < 1e9)) { // also 0 and non-finite values
        return format("%.*g", digits, value);
    }
    const int whole = static_cast<int>(std::floor(std::log10(size))) + 1;
    std::string text = format("%.*f", std::max(0, digits - whole), value);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        text.erase(text.find_last_not_of('.') + 1);
    }
    return text;
}

std::string grouped(double value, int digits) {
    const std::string text = number(value, digits);
    const std::size_t begin = text.starts_with('-') ? 1 : 0;
    const std::size_t end = std::min(text.find_first_not_of("0123456789", begin), text.size());
    const bool exponent = text.find_first_of("en", begin) != std::string::npos; // also inf and nan
    return exponent ? text
                    : text.substr(0, begin) + groupedDigits(std::string_view(text).substr(begin, end - begin)) +
                          text.substr(end);
}

std::string editedNumber(double value) {
    value += 0.0; // no negative zero
    const double size = std::abs(value);
    if (value != 0.0 && !(size >= 1e-4 && size < 1e15)) {
        return exactText(value);
    }
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    return {text.data(), end.ptr};
}

std::string listedNumber(double value) {
    constexpr int kDigits = 12;
    return editedNumber(roundedTo(value, kDigits));
}

std::string mean(double value) {
    return format("%.*f", value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2, value);
}

} // namespace forefront::ui
