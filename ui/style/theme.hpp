#pragma once

#include "ui/style/colour.hpp"

#include <cstdint>

namespace forefront {

enum class ThemeKind : std::uint8_t { Dark, Light };

/// All colours of the program, by meaning.
struct Theme {
    ThemeKind kind = ThemeKind::Dark;

    // surfaces
    Colour canvas = 0;  ///< outside the domain
    Colour domain = 0;  ///< inside the domain
    Colour panel = 0;   ///< panels, bars
    Colour raised = 0;  ///< fields, buttons
    Colour hovered = 0; ///< ... under the pointer
    Colour pressed = 0;
    Colour line = 0; ///< hairlines between surfaces
    Colour popup = 0;
    Colour dim = 0; ///< over the window behind a dialog

    // text
    Colour text = 0;
    Colour muted = 0; ///< labels, units
    Colour faint = 0; ///< disabled, placeholders
    Colour onAccent = 0;

    // meaning
    Colour accent = 0; ///< primary action, selection, focus
    Colour good = 0;   ///< accepted, valid
    Colour bad = 0;    ///< rejected, error
    Colour warn = 0;   ///< out of date, warning

    // canvas
    Colour boundary = 0;   ///< domain boundary
    Colour constraint = 0; ///< constraint segments and points
    Colour selection = 0;
    Colour mesh = 0;      ///< edges of the mesh
    Colour element = 0;   ///< faces of elements not coloured by a value
    Colour front = 0;     ///< generation front Γ
    Colour base = 0;      ///< base segment AB
    Colour candidate = 0; ///< candidate nodes and segments not yet judged
    Colour cell = 0;      ///< occupied cells of the background grid
    Colour visited = 0;   ///< cells visited in this step
    Colour gridLine = 0;  ///< drawing grid
    Colour brush = 0;
};

Theme makeTheme(ThemeKind kind);
/// Sets colours, rounding and spacing of Dear ImGui at `scale` pixels per design pixel.
void applyTheme(const Theme &theme, float scale);

} // namespace forefront
