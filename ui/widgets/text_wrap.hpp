#pragma once

#include <string>
#include <string_view>

namespace forefront::ui {

/// Wraps `text` between words, so that no line is wider than `width` pixels in the current font, except for single
/// words. Dear ImGui by itself also breaks lines after the point of a number: "0." and "799".
std::string wrapped(std::string_view text, float width);
/// Wraps `text` to at most two lines; text that does not fit is replaced by "…". Empty lines after the second are
/// ignored.
std::string twoLines(std::string_view text, float width);
/// Returns as many words of `text` as fit into a line of `width` pixels, followed by "…" if some are left out.
std::string oneLine(std::string_view text, float width);
/// Draws text in lines of at most `width` pixels; 0: of all that is left in the row. Longer words are split.
void wrappedText(std::string_view text, float width = 0.0F);

} // namespace forefront::ui
