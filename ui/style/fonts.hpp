#pragma once

#include <string>

struct ImFont;

namespace forefront {

/// The fonts of the program: Inter in a few sizes, each with the icons of the program. Sizes are those of the em in
/// design pixels. All digits of a font have the same width, so that changing numbers do not move the text beside them.
struct Fonts {
    ImFont *body = nullptr;        ///< 13, regular: everything
    ImFont *strong = nullptr;      ///< 13, semi-bold: values, active
    ImFont *small = nullptr;       ///< 12, regular: captions, ticks, units, heads of tables
    ImFont *heading = nullptr;     ///< 13, semi-bold: headings of panels
    ImFont *title = nullptr;       ///< 16, semi-bold: dialogs
    ImFont *page = nullptr;        ///< 20, semi-bold: help, lessons
    ImFont *icons = nullptr;       ///< icons of 20 pixels, for buttons; those of the other fonts have 16
    ImFont *mono = nullptr;        ///< 12: hashes, expressions
    ImFont *italic = nullptr;      ///< 13, italic: letters of formulas
    ImFont *index = nullptr;       ///< 10, regular: indices and exponents of formulas
    ImFont *indexItalic = nullptr; ///< 10, italic: their letters
    ImFont *sum = nullptr;         ///< 20, regular: only ∑, ∏ and ∫ of formulas
};

/// Builds the font atlas of the current Dear ImGui context at `scale` pixels per design pixel. A missing font falls
/// back to one that is installed, down to Dear ImGui's own; `warning` then names the packages to install.
Fonts loadFonts(float scale, std::string &warning);

} // namespace forefront
