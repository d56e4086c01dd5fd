#pragma once

#include "core/engine/base/result.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// The kind of a part of a formula in a text.
enum class MathKind : std::uint8_t {
    Symbol,   ///< characters that are set as they are
    Row,      ///< parts side by side
    Fraction, ///< numerator and denominator
    Root,     ///< radicand, and perhaps the degree
    Scripts,  ///< base, then the subscript if it has one, then the superscript if it has one
    Overline, ///< one part with a line above it
    Fence,    ///< one part between brackets as high as it is
    Space     ///< empty room
};

/// The role of a symbol, by which the room around it is chosen.
enum class MathRole : std::uint8_t {
    Ordinary,
    Binary,   ///< such as +
    Relation, ///< such as =
    Opening,
    Closing,
    Comma,
    Function, ///< a name such as sin
    Limit,    ///< a name with its subscript below, such as max
    Large,    ///< ∑ or ∏, with its limits above and below
    Integral
};

/// A part of a formula, and what it consists of.
struct MathNode {
    MathKind kind = MathKind::Row;
    MathRole role = MathRole::Ordinary; ///< of a symbol
    bool italic = false;                ///< of a symbol
    std::string text{};                 ///< of a symbol; the opening bracket of a fence
    std::string closing{};              ///< the closing bracket of a fence
    double room = 0.0;                  ///< width of a space, in ems
    bool sub = false, super = false;    ///< the scripts that it has
    std::vector<MathNode> parts{};
};

/// Reads a formula in the subset of TeX that assets/lessons/README.md lists. Fault: "bad-formula", whose `column` is
/// the byte of the text where the fault is, from 1.
Result<MathNode> parseMath(std::string_view text);

/// Returns the role of a part: that of its symbol or its base.
MathRole roleOf(const MathNode &node);
/// Returns true if a part with a role is a sign, as the minus in −x or sin −x, not an operator between two parts.
/// `before`: the role of the part before it, Opening for the first one and after a sign.
bool isSign(MathRole role, MathRole before);
/// Returns the symbols or parts beside each other of which a formula consists; a row of its own: its parts.
std::vector<MathNode> partsOf(const MathNode &formula);
/// Returns a formula in pieces that a line may end after: after each relation and, unless it is a sign, after each
/// binary operator outside brackets.
std::vector<MathNode> brokenMath(const MathNode &formula);
/// Returns a formula as a line of plain text, as it is read aloud and searched: "ρ = h√(E/e)".
std::string plainMath(const MathNode &formula);

} // namespace forefront
