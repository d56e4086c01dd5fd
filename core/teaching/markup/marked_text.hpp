#pragma once

#include "core/engine/base/result.hpp"
#include "core/teaching/markup/math.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

/// The kind of a piece of a text.
enum class PieceKind : std::uint8_t { Words, Formula, Image, Link };

/// A piece of a text of a lesson.
struct TextPiece {
    PieceKind kind = PieceKind::Words;
    std::string text{};   ///< words; of a link, its words; of an image, what it shows, in words
    MathNode formula{};   ///< of a formula
    std::string target{}; ///< file of an image; page of a link, its number or title
    double share = 1.0;   ///< of an image: width, as a share of the column; not set in the text: at most that
    bool sized = false;   ///< the text sets the width of an image
    std::size_t at = 0;   ///< where it begins in the text, in bytes
};

/// What a text may consist of beside words.
enum class MarkupKind : std::uint8_t {
    Formulas, ///< such as the text of a choice, which is a button
    All       ///< formulas, images and links
};

/// Reads the formulas, images and links of a text. Faults, whose `column` is the byte of the text where the fault is,
/// from 1: "bad-formula"; "bad-image", one without words or with a width that is none; "bad-link".
Result<std::vector<TextPiece>> parseMarkup(std::string_view text, MarkupKind kind = MarkupKind::All);

/// Returns the pieces of a text whose markup has been checked; a text with a fault is words only.
std::vector<TextPiece> piecesOf(std::string_view text, MarkupKind kind = MarkupKind::All);
/// Returns the words of a text, with its formulas in plain text, the words of its links, and no images.
std::string plainText(std::string_view text);

} // namespace forefront
