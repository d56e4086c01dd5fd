#include "core/engine/base/length_unit.hpp"

#include <cstddef>

namespace forefront {

namespace {

/// The lengths of the units in tenths of a millimetre, which are whole numbers.
constexpr std::array<double, 7> kTenths = {0.0, 10.0, 100.0, 10'000.0, 10'000'000.0, 254.0, 3048.0};

double tenthsOf(LengthUnit unit) {
    return kTenths[static_cast<std::size_t>(unit)];
}

} // namespace

double metresPer(LengthUnit unit) {
    return tenthsOf(unit) / 10'000.0;
}

std::optional<double> conversion(LengthUnit from, LengthUnit to) {
    if (from == LengthUnit::None || to == LengthUnit::None) {
        return std::nullopt;
    }
    return tenthsOf(from) / tenthsOf(to);
}

std::string_view pluralOf(LengthUnit unit) {
    constexpr std::array<std::string_view, 7> kNames = {"no unit",    "millimetres", "centimetres", "metres",
                                                        "kilometres", "inches",      "feet"};
    return kNames[static_cast<std::size_t>(unit)];
}

std::string unitSuffix(LengthUnit unit) {
    return unit == LengthUnit::None ? std::string() : ' ' + std::string(wordOf(unit));
}

std::optional<LengthUnit> typedUnit(std::string_view word) {
    if (word == "\"") {
        return LengthUnit::Inch;
    }
    if (word == "'") {
        return LengthUnit::Foot;
    }
    return fromWord<LengthUnit>(word);
}

} // namespace forefront
