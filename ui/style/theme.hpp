#pragma once

#include "ui/style/colour.hpp"

#include <cstdint>

namespace forefront {

enum class ThemeKind : std::uint8_t { Dark, Light };

/// All colours of the program, by meaning.
struct Theme {
    ThemeKind kind = ThemeKind::Dark;

    // surfaces
    Colour canvas;  ///< outside the domain
    Colour domain;  ///< inside the domain
    Colour panel;   ///< panels, bars
    Colour raised;  ///< fields, buttons
    Colour hovered; ///< ... under the pointer
    Colour pressed;
    Colour line; ///< hairlines between surfaces
    Colour popup;
    Colour dim; ///< over the window behind a dialog

    // text
    Colour text;
    Colour muted; ///< labels, units
    Colour faint; ///< disabled, placeholders
    Colour onAccent;

    // meaning
    Colour accent; ///< primary action, selection, focus
    Colour good;   ///< accepted, valid
    Colour bad;    ///< rejected, error
    Colour warn;   ///< out of date, warning

    // canvas
    Colour boundary;   ///< domain boundary
    Colour constraint; ///< constraint segments and points
    Colour selection;
    Colour mesh;      ///< edges of the mesh
    Colour compared;  ///< edges of a mesh laid over that of the canvas
    Colour element;   ///< faces of elements not coloured by a value
    Colour front;     ///< generation front Γ
    Colour base;      ///< base segment AB
    Colour candidate; ///< candidate nodes and segments not yet tested
    Colour cell;      ///< occupied cells of the background grid
    Colour visited;   ///< cells visited in this step
    Colour gridLine;  ///< drawing grid
    Colour brush;
};

Theme makeTheme(ThemeKind kind);
/// Sets colours, rounding and spacing of Dear ImGui at `scale` pixels per design pixel.
void applyTheme(const Theme &theme, float scale);

} // namespace forefront
