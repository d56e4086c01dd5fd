#pragma once

namespace forefront {

/// Opacity of spacingColour() over the domain: the colours show the spacing and leave the mesh legible.
inline constexpr double kSpacingTint = 0.45;

} // namespace forefront
