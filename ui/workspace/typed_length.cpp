#include "ui/workspace/typed_length.hpp"

#include "core/engine/base/number_text.hpp"
#include "ui/widgets/parse_number.hpp"

#include <array>

namespace forefront {

namespace {

/// Returns the number before a word at the end of a text; empty if there is none.
std::string_view numberBefore(std::string_view text, std::string_view word) {
    if (!text.ends_with(word)) {
        return {};
    }
    const std::string_view head = trimmed(text.substr(0, text.size() - word.size()));
    return parseNumber(head) ? head : std::string_view();
}

} // namespace

std::optional<TypedLength> parseTypedLength(std::string_view text) {
    text = trimmed(text);
    // "m" must come after the words that end with it.
    constexpr std::array<std::string_view, 11> kWords = {"mm", "cm", "km", "m",   "in",      "ft",
                                                         "\"", "'",  "px", "deg", "\xc2\xb0"};
    for (const std::string_view word : kWords) {
        if (const std::string_view number = numberBefore(text, word); !number.empty()) {
            return TypedLength{std::string(number), *parseNumber(number), typedUnit(word).value_or(LengthUnit::None)};
        }
    }
    return std::nullopt;
}

std::string inUnit(const std::string &text, LengthUnit unit) {
    const std::optional<TypedLength> typed = parseTypedLength(text);
    const std::optional<double> factor = typed ? conversion(typed->unit, unit) : std::nullopt;
    return factor ? exactText(*factor * typed->value) : text;
}

std::string areaSuffix(LengthUnit unit) {
    return unit == LengthUnit::None ? std::string() : unitSuffix(unit) + "\xc2\xb2";
}

std::string unitFault(const Document &document, std::string_view text) {
    const std::optional<TypedLength> typed = parseTypedLength(text);
    if (!typed) {
        return {};
    }
    if (typed->unit != LengthUnit::None && document.unit == LengthUnit::None) {
        return "the drawing has no unit; enter " + typed->number + " alone, or choose Edit > Unit";
    }
    return "this field takes no unit; enter " + typed->number + " alone";
}

} // namespace forefront
