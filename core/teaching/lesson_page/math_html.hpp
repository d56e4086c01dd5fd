#pragma once

#include "core/teaching/markup/math.hpp"

#include <string>
#include <string_view>

namespace forefront {

/// Returns a text as HTML that may also stand in the value of an attribute.
std::string escapedHtml(std::string_view text);
/// Returns a formula as HTML that lesson.css lays out, named by its plain text. It uses the font of the text alone: the
/// browser's own layout of formulas (MathML) needs a font for them to draw roots. `display`: on a line of its own.
std::string mathHtml(const MathNode &formula, bool display);

} // namespace forefront
