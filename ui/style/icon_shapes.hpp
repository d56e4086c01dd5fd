#pragma once

#include <span>

namespace forefront {

/// The shape of an icon on a grid of 20 x 20, with y down. Paths are those of SVG with the commands M, L, H, V, A, C
/// and Z, in capitals; an empty text draws nothing. ui/style/README.md gives the rules for drawing one.
struct IconShape {
    const char *text;        ///< the character of the icon, see ui/style/icons.hpp
    const char *meaning;     ///< the one thing that it stands for
    const char *stroke;      ///< lines 1.5 wide with round ends and corners
    const char *helper = ""; ///< thinner and fainter lines: what is measured, not what is made
    const char *dashed = ""; ///< lines like `stroke`, dashed
    const char *fill = "";   ///< filled areas
    const char *nodes = "";  ///< centres "x y ..." of the squares that a user clicks
    const char *dots = "";   ///< discs "x y radius ..."
};

/// Returns all icons of the program.
std::span<const IconShape> iconShapes();

} // namespace forefront
