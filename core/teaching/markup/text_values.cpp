#include "core/teaching/markup/text_values.hpp"

#include <algorithm>

namespace forefront {

namespace {

constexpr std::string_view kCommand = "\\value";

/// Returns a number as a group of TeX.
std::string inTex(const std::string &number) {
    const std::size_t e = number.find('e');
    if (e == std::string::npos) {
        return '{' + number + '}';
    }
    std::string exponent = number.substr(e + 1);
    const bool negative = exponent.starts_with('-');
    exponent.erase(0, exponent.find_first_not_of("+-0"));
    return '{' + number.substr(0, e) + "\\cdot 10^{" + (negative ? "-" : "") + exponent + "}}";
}

} // namespace

std::vector<NamedValue> valuesNamed(std::string_view text) {
    std::vector<NamedValue> values;
    bool inFormula = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const bool command =
            inFormula && text.substr(at).starts_with(kCommand) && text.substr(at + kCommand.size()).starts_with('{');
        const std::string_view escaped = inFormula ? std::string_view() : "$[!\\";
        if (!command && text[at] == '\\' && at + 1 < text.size() &&
            (inFormula || escaped.find(text[at + 1]) != std::string_view::npos)) {
            ++at; // the next character means nothing
            continue;
        }
        inFormula = text[at] == '$' ? !inFormula : inFormula;
        if (!command && (inFormula || text[at] != '{')) {
            continue;
        }
        const std::size_t open = command ? at + kCommand.size() : at;
        const std::size_t close = std::min(text.find('}', open), text.size());
        const std::size_t end = std::min(close + 1, text.size());
        values.push_back({at, end, text.substr(open + 1, close - open - 1), close < text.size(), inFormula});
        at = end - 1;
    }
    return values;
}

std::string withValuesReplaced(std::string_view text,
                               const std::function<std::optional<std::string>(std::string_view word)> &number) {
    std::string result;
    std::size_t done = 0;
    for (const NamedValue &value : valuesNamed(text)) {
        const std::optional<std::string> shown = value.closed ? number(value.word) : std::nullopt;
        if (shown) {
            result += text.substr(done, value.begin - done);
            result += value.inFormula ? inTex(*shown) : *shown;
            done = value.end;
        }
    }
    result += text.substr(done);
    return result;
}

} // namespace forefront
