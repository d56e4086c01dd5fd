#include "core/files/nastran/nastran_real.hpp"

#include "core/files/text/text_scanner.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace forefront {

namespace {

/// A number as digits d and an exponent e: d[0].d[1]d[2]... times 10^e.
struct Decimal {
    bool negative = false;
    std::string digits;
    int exponent = 0;
};

/// Returns a number with `count` digits, or with the fewest that read back to the same bits if `count` is 0.
Decimal decimalOf(double value, int count) {
    std::array<char, 40> text;
    char *const end = text.data() + text.size();
    const auto written = count == 0 ? std::to_chars(text.data(), end, value, std::chars_format::scientific)
                                    : std::to_chars(text.data(), end, value, std::chars_format::scientific, count - 1);
    Decimal decimal;
    std::string_view rest(text.data(), static_cast<std::size_t>(written.ptr - text.data()));
    if (rest.starts_with('-')) {
        decimal.negative = true;
        rest.remove_prefix(1);
    }
    const std::size_t e = rest.find('e');
    for (const char c : rest.substr(0, e)) {
        if (c != '.') {
            decimal.digits += c;
        }
    }
    std::string_view exponent = rest.substr(e + 1);
    exponent.remove_prefix(exponent.starts_with('+') ? 1 : 0);
    std::from_chars(exponent.data(), exponent.data() + exponent.size(), decimal.exponent);
    decimal.digits.resize(std::max<std::size_t>(decimal.digits.find_last_not_of('0') + 1, 1));
    return decimal;
}

std::string fixedText(const Decimal &decimal, bool leadingZero) {
    std::string text = decimal.negative ? "-" : "";
    const auto size = static_cast<int>(decimal.digits.size());
    if (decimal.exponent < 0) {
        return text + (leadingZero ? "0." : ".") + std::string(static_cast<std::size_t>(-decimal.exponent - 1), '0') +
               decimal.digits;
    }
    if (size <= decimal.exponent + 1) {
        return text + decimal.digits + std::string(static_cast<std::size_t>(decimal.exponent + 1 - size), '0') + '.';
    }
    const auto whole = static_cast<std::size_t>(decimal.exponent + 1);
    return text + decimal.digits.substr(0, whole) + '.' + decimal.digits.substr(whole);
}

std::string exponentText(const Decimal &decimal) {
    return (decimal.negative ? "-" : "") + decimal.digits.substr(0, 1) + '.' + decimal.digits.substr(1) + 'E' +
           std::to_string(decimal.exponent);
}

} // namespace

NastranReal nastranReal(double value, std::size_t width) {
    if (value == 0.0) {
        return {"0.", false};
    }
    for (int count = 0; count != 1; count = count == 0 ? 16 : count - 1) {
        const Decimal decimal = decimalOf(value, count);
        if (std::abs(decimal.exponent) < 20) {
            for (const bool leadingZero : {true, false}) {
                if (std::string text = fixedText(decimal, leadingZero); text.size() <= width) {
                    return {text, count != 0 && parseReal(text) != value};
                }
            }
        }
        if (std::string text = exponentText(decimal); text.size() <= width) {
            return {text, count != 0 && parseReal(text) != value};
        }
    }
    const std::string text = exponentText(decimalOf(value, 1));
    return {text, parseReal(text) != value};
}

std::optional<double> readNastranReal(std::string_view text) {
    const std::size_t sign = text.find_last_of("+-");
    if (sign != std::string_view::npos && sign > 0 &&
        ((text[sign - 1] >= '0' && text[sign - 1] <= '9') || text[sign - 1] == '.')) {
        std::string full(text);
        full.insert(sign, 1, 'e');
        return parseReal(full);
    }
    return parseReal(text);
}

} // namespace forefront
