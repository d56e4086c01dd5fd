#pragma once

#include "ui/style/theme.hpp"

namespace forefront {

/// Returns the opacity of spacingColour() over the domain: the colours show the spacing and leave the mesh legible. On
/// a dark ground, more of the bright colours would need edges that glare on the others.
constexpr double spacingTint(ThemeKind theme) {
    return theme == ThemeKind::Dark ? 0.35 : 0.45;
}

} // namespace forefront
