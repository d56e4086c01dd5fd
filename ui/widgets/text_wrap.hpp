#pragma once

#include <string>
#include <string_view>

namespace forefront::ui {

/// `text` with line ends between words, so that no line is wider than `width` pixels in the font of the moment, save
/// those of a single word. Dear ImGui by itself also breaks lines after the point of a number: "0." and "799".
std::string wrapped(std::string_view text, float width);
/// Draws text in lines of at most `width` pixels; 0: of all that is left in the row. Longer words are broken.
void wrappedText(std::string_view text, float width = 0.0F);

} // namespace forefront::ui
