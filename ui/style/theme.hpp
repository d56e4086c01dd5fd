#pragma once

#include "ui/style/colour.hpp"

#include <cstdint>

namespace forefront {

enum class ThemeKind : std::uint8_t { Dark, Light };

/// All colours of the program, by meaning.
struct Theme {
    ThemeKind kind = ThemeKind::Dark;

    // surfaces, from low to high
    Colour canvas;      ///< outside the domain
    Colour domain;      ///< inside the domain
    Colour panel;       ///< panels, bars
    Colour inset;       ///< what is typed in: fields, tracks of sliders
    Colour fieldBorder; ///< edge of what is typed in
    Colour raised;      ///< what is pressed: buttons
    Colour hovered;     ///< ... under the pointer
    Colour pressed;     ///< ... held down, or on
    Colour line;        ///< hairlines between surfaces
    Colour popup;       ///< menus, dialogs, plates on the canvas
    Colour popupBorder; ///< edge of those
    Colour selectedRow; ///< of a list
    Colour dim;         ///< over the window behind a dialog

    // text
    Colour text;
    Colour muted;       ///< labels, units
    Colour placeholder; ///< example in an empty field
    Colour faint;       ///< disabled
    Colour onAccent;

    // meaning
    Colour accent; ///< focus, selection and the primary action, nothing else
    Colour good;   ///< valid, met
    Colour bad;    ///< rejected, error
    Colour warn;   ///< out of date, warning; always beside its icon

    // canvas
    Colour boundary;   ///< domain boundary
    Colour constraint; ///< constraint segments and points, guides
    Colour determined; ///< parts of a sketch that its constraints leave no freedom
    Colour selection;
    Colour mesh;       ///< edges of the mesh
    Colour meshOnTint; ///< ... over the colours of the node spacing
    Colour compared;   ///< edges of a mesh laid over that of the canvas
    Colour element;    ///< faces of elements not coloured by a value
    Colour front;      ///< generation front Γ
    Colour base;       ///< base segment AB
    Colour core;       ///< of the line of the base
    Colour accepted;   ///< accepted candidate and its element
    Colour candidate;  ///< candidate nodes and segments not yet tested, search circle
    Colour cell;       ///< occupied cells of the background grid
    Colour visited;    ///< cells visited in this step
    Colour gridLine;   ///< drawing grid
    Colour brush;
};

Theme makeTheme(ThemeKind kind);
/// Returns the colour of the plate of a label on the canvas: text is legible on it whatever line lies below.
inline Colour labelPlate(const Theme &theme) {
    return fade(theme.popup, 0.92);
}
/// Sets colours, rounding and spacing of Dear ImGui at `scale` pixels per design pixel.
void applyTheme(const Theme &theme, float scale);

} // namespace forefront
