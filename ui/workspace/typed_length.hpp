#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/length_unit.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace forefront {

/// A typed number with a unit, such as "2 in".
struct TypedLength {
    std::string number;
    double value = 0.0;
    LengthUnit unit = LengthUnit::None; ///< none: one that is known, but no unit of length
};

/// Returns the number and the unit of a text; none if it is not a number with a unit.
std::optional<TypedLength> parseTypedLength(std::string_view text);

/// Returns a text with its unit converted: "2 in" is "50.8" in millimetres. A text without a unit of length stays as it
/// is, and so do all where `unit` is none.
std::string inUnit(const std::string &text, LengthUnit unit);

/// Returns the square of a unit as it follows an area, " m²"; empty without a unit.
std::string areaSuffix(LengthUnit unit);

/// Returns why a text with a unit that inUnit() has not converted is no number; empty for one without a unit.
std::string unitFault(const Document &document, std::string_view text);

} // namespace forefront
