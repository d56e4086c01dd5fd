#pragma once

#include <string>

struct ImFont;

namespace forefront {

/// The fonts of the program: Inter in a few sizes, each with the icons of Font Awesome. Sizes are in design pixels. All
/// digits of a font have the same width, so that changing numbers do not move the text beside them.
struct Fonts {
    ImFont *body = nullptr;    ///< 14, regular: everything
    ImFont *strong = nullptr;  ///< 14, semi-bold: values, active
    ImFont *small = nullptr;   ///< 13, regular: captions, ticks, units
    ImFont *heading = nullptr; ///< 13, semi-bold: headings of panels
    ImFont *title = nullptr;   ///< 20, semi-bold: dialogs, help
    ImFont *icons = nullptr;   ///< 17: tool strip and transport
    ImFont *mono = nullptr;    ///< 13: hashes, expressions
};

/// Builds the font atlas of the current Dear ImGui context at `scale` pixels per design pixel. A missing font falls
/// back to one that is installed, down to Dear ImGui's own; `warning` then names the packages to install.
Fonts loadFonts(float scale, std::string &warning);

} // namespace forefront
