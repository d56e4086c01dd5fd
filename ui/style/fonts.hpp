#pragma once

#include <string>

struct ImFont;

namespace forefront {

/// The type of the program: Inter in few sizes, with the icons of Font Awesome in each. Sizes in design pixels.
struct Fonts {
    ImFont *body = nullptr;    ///< 14, regular: everything
    ImFont *strong = nullptr;  ///< 14, semi-bold: values, active
    ImFont *small = nullptr;   ///< 12, regular: captions, ticks, units
    ImFont *heading = nullptr; ///< 11, semi-bold: capitals over panels
    ImFont *title = nullptr;   ///< 20, semi-bold: dialogs, help
    ImFont *icons = nullptr;   ///< 17: tool strip and transport
    ImFont *mono = nullptr;    ///< 13: hashes, expressions
};

/// Builds the font atlas of the current Dear ImGui context at `scale` pixels per design pixel. What is missing falls
/// back to a font that is there, down to Dear ImGui's own; `warning` then says what to install.
Fonts loadFonts(float scale, std::string &warning);

} // namespace forefront
