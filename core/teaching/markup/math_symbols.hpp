#pragma once

#include "core/teaching/markup/math.hpp"

#include <optional>
#include <string_view>

namespace forefront {

/// A symbol of formulas.
struct MathSymbol {
    std::string_view command; ///< without the backslash; empty: only the character
    std::string_view text;    ///< as it is shown
    MathRole role = MathRole::Ordinary;
};

/// Returns the symbol of a command without its backslash; nothing if it is not the command of a symbol.
std::optional<MathSymbol> symbolOfCommand(std::string_view command);
/// Returns the symbol that a character in a formula stands for; nothing if formulas do not have it. Letters and digits
/// are no symbols here.
std::optional<MathSymbol> symbolOfCharacter(std::string_view character);
/// Returns the room of a command for a space, in ems; nothing if it is none.
std::optional<double> roomOfCommand(std::string_view command);

} // namespace forefront
