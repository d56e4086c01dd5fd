#include "core/drawing/formulas/shift_formulas.hpp"

#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/place_formulas.hpp"
#include "core/engine/base/number_text.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace forefront {
namespace {

/// Returns the change of a number of an item that is moved; 0 for numbers that are not coordinates.
double shiftAlong(Quantity what, Vec2 by) {
    switch (what) {
    case Quantity::X:
    case Quantity::X2:
    case Quantity::Left:
        return by.x;
    case Quantity::Y:
    case Quantity::Y2:
    case Quantity::Bottom:
        return by.y;
    default:
        return 0.0;
    }
}

/// An expression split into another expression plus a number.
struct Sum {
    std::string first;
    double number = 0.0;
};

/// Returns true for the last character of an operand.
bool endsOperand(char c) {
    return c == ')' || c == '.' || c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
           (c >= 'A' && c <= 'Z');
}

/// Takes the number off the end of an expression, as sumFormula() writes it there.
Sum withoutNumber(const std::string &text) {
    const std::size_t sign = text.find_last_of("+-");
    const bool between = sign != std::string::npos && sign >= 2 && sign + 2 < text.size() &&
                         endsOperand(text[sign - 2]) && text[sign - 1] == ' ' && text[sign + 1] == ' ';
    if (!between || text.find_first_of("?:<>=!&|") != std::string::npos) {
        return {text, 0.0};
    }
    const std::optional<double> number = plainNumber(text.substr(sign + 2));
    return number ? Sum{text.substr(0, sign - 1), text[sign] == '-' ? -*number : *number} : Sum{text, 0.0};
}

/// Returns an expression plus a number. A number that the expression ends in, as in "w + 2", takes it in, so that the
/// text does not grow with every move.
std::string shifted(const std::string &text, double by, bool exactly) {
    constexpr int kDigits = 12;
    const Sum sum = withoutNumber(text);
    const double number = sum.number + by;
    return sumFormula(sum.first, exactly ? exactText(number) : numberText(number, kDigits));
}

/// Returns the formula of a coordinate that was moved. Differences of coordinates are rounded, so the shift is written
/// with few digits if the formula still gives the coordinate: 0.1 rather than 0.09999999999999964.
std::string shiftedFormula(const Document &document, const NumberAddress &number, const std::string &text, double by) {
    std::string brief = shifted(text, by, false);
    const Result<double> value = evaluateFormula(document, brief);
    return value && hasValue(document, number, *value) ? brief : shifted(text, by, true);
}

} // namespace

void shiftFormulas(Document &document, NumberOwner owner, Vec2 by) {
    for (auto &[address, text] : formulasOf(document, owner)) {
        if (const double shift = shiftAlong(address.quantity, by); shift != 0.0) {
            text = shiftedFormula(document, address, text, shift);
        }
    }
}

} // namespace forefront
