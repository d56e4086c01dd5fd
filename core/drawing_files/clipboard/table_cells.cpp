#include "core/drawing_files/clipboard/table_cells.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace forefront {

namespace {

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

bool areDigits(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), isDigit);
}

std::string_view withoutSign(std::string_view text) {
    return text.substr(text.starts_with('+') || text.starts_with('-') ? 1 : 0);
}

/// Returns the number that is all of `text`, which has no sign.
std::optional<double> wholeNumber(std::string_view text) {
    if (text.empty() || !(isDigit(text[0]) || text[0] == '.')) {
        return std::nullopt;
    }
    double value = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good = fault == std::errc() && end == text.data() + text.size() && std::isfinite(value);
    return good ? std::optional(value) : std::nullopt;
}

/// Returns digits without the sign between their groups: one to three digits, then groups of three. None if they have
/// other groups.
std::optional<std::string> withoutThousands(std::string_view digits, char separator) {
    std::string joined;
    for (bool first = true; first || !digits.empty(); first = false) {
        const std::size_t end = std::min(digits.find(separator), digits.size());
        const std::string_view group = digits.substr(0, end);
        if (!areDigits(group) || group.size() > 3 || (!first && group.size() < 3) || end + 1 == digits.size()) {
            return std::nullopt;
        }
        joined += group;
        digits.remove_prefix(std::min(end + 1, digits.size()));
    }
    return joined;
}

} // namespace

std::optional<double> numberInCell(std::string_view cell) {
    const std::string_view text = withoutSign(cell);
    const std::size_t last = text.find_last_of(".,");
    if (last == std::string_view::npos) {
        const std::optional<double> value = wholeNumber(text);
        return value && cell.starts_with('-') ? -*value : value;
    }
    if (text.find(text[last]) != last) {
        return std::nullopt; // two decimal signs
    }
    const char thousands = text[last] == ',' ? '.' : ',';
    std::string digits(text.substr(0, last));
    if (digits.find(thousands) != std::string::npos) {
        const std::optional<std::string> joined = withoutThousands(digits, thousands);
        if (!joined) {
            return std::nullopt;
        }
        digits = *joined;
    }
    const std::optional<double> value = wholeNumber(digits + '.' + std::string(text.substr(last + 1)));
    return value && cell.starts_with('-') ? -*value : value;
}

CommaUse commaUse(std::string_view cell) {
    const std::string_view text = withoutSign(cell);
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) {
        return CommaUse::None;
    }
    if (const std::size_t point = text.find('.'); point != std::string_view::npos) {
        return comma < point ? CommaUse::Thousands : CommaUse::Decimal;
    }
    const std::string_view after = text.substr(comma + 1);
    const bool grouped = comma >= 1 && comma <= 3 && text[0] != '0' && after.size() == 3 && areDigits(after);
    return grouped ? CommaUse::Either : CommaUse::Decimal;
}

std::string_view trimmedCell(std::string_view cell) {
    constexpr std::string_view kAround = " \t\r\"'()[]{}";
    cell.remove_prefix(std::min(cell.find_first_not_of(kAround), cell.size()));
    cell.remove_suffix(cell.size() - (cell.find_last_not_of(kAround) + 1));
    return cell;
}

std::vector<std::string_view> cellsOf(std::string_view line, char separator) {
    const std::string_view ends = separator == ' ' ? std::string_view(" \t\r") : std::string_view(&separator, 1);
    std::vector<std::string_view> cells;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find_first_of(ends, begin), line.size());
        if (end > begin || separator != ' ') {
            cells.push_back(trimmedCell(line.substr(begin, end - begin)));
        }
        begin = end + 1;
    }
    return cells;
}

} // namespace forefront
