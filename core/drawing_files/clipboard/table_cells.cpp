#include "core/drawing_files/clipboard/table_cells.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace forefront {

namespace {

bool beginsNumber(char c) {
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
}

/// Returns the number that is all of `text`.
std::optional<double> wholeNumber(std::string_view text) {
    if (text.empty() || !beginsNumber(text[0])) {
        return std::nullopt;
    }
    text.remove_prefix(text[0] == '+' ? 1 : 0);
    double value = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good = fault == std::errc() && end == text.data() + text.size() && std::isfinite(value);
    return good ? std::optional(value) : std::nullopt;
}

} // namespace

std::optional<double> numberInCell(std::string_view cell) {
    const std::size_t last = cell.find_last_of(".,");
    if (last != std::string_view::npos && cell.find(cell[last]) != last) {
        return std::nullopt; // two decimal signs
    }
    std::string digits;
    for (std::size_t k = 0; k < cell.size(); ++k) {
        if (k == last) {
            digits += '.';
        } else if (cell[k] != '.' && cell[k] != ',') {
            digits += cell[k];
        }
    }
    return wholeNumber(digits);
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
