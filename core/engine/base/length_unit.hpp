#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace FOREFRONT_API forefront {

/// The unit of the coordinates of a drawing. Meshing does not depend on it: files and fields name it.
enum class LengthUnit : std::uint8_t { None, Millimetre, Centimetre, Metre, Kilometre, Inch, Foot };

template <>
struct EnumWords<LengthUnit> {
    static constexpr auto kLast = LengthUnit::Foot;
    static constexpr std::array<std::string_view, 7> kList = {"none", "mm", "cm", "m", "km", "in", "ft"};
};

/// Returns the length of a unit in metres; 0 for none. An inch is 25.4 mm and a foot 12 inches exactly (international
/// yard and pound agreement, 1959).
double metresPer(LengthUnit unit);

/// Returns the factor that turns lengths in `from` into lengths in `to`, correctly rounded where it is a ratio of small
/// whole numbers; none if either has no unit.
std::optional<double> conversion(LengthUnit from, LengthUnit to);

/// Returns the name of a unit in the plural, such as "millimetres"; "no unit" for none.
std::string_view pluralOf(LengthUnit unit);

/// Returns what stands after a number in a unit, such as " mm"; empty for none.
std::string unitSuffix(LengthUnit unit);

/// Returns the unit with a word as users type it: a word of the list, or " for inches, ' for feet; none if there is
/// none.
std::optional<LengthUnit> typedUnit(std::string_view word);

} // namespace forefront
