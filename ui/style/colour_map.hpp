#pragma once

#include "ui/style/colour.hpp"

namespace forefront {

/// Perceptually uniform colour maps for t in [0, 1], interpolated between tabulated support colours of the published
/// maps (viridis: N. Smith and S. van der Walt; cividis: J. Nuñez, C. Anderton, R. Renslow).
Colour viridis(double t);
Colour cividis(double t);
/// Cividis from its bright end to its dark one.
Colour cividisReversed(double t);
/// Maps with a quiet middle, purple at t = 0 and orange at t = 1, that are also safe for the colour-blind: PuOr of C.
/// Brewer, and the same on a dark ground.
Colour diverging(double t);
Colour divergingDark(double t);
/// Maps of a quality, red at t = 0, amber in the middle, and close to the ground at t = 1, on a dark and on a light
/// ground: what is good recedes, what is bad stands out.
Colour qualityDark(double t);
Colour qualityLight(double t);
/// The same from good to bad.
Colour qualityDarkReversed(double t);
Colour qualityLightReversed(double t);
/// Eight colours that the colour-blind can tell apart (M. Okabe, K. Ito), each for an eighth of [0, 1].
Colour categories(double t);
/// A colour map.
using ColourMap = Colour (*)(double);
/// Colour of the node spacing, the same in both themes: bright yellow where it is finest (t = 0), blue where it is
/// coarsest (t = 1). The darkest quarter of viridis is left out, so that the edges of a mesh stay visible on it.
Colour spacingColour(double t);

/// The values at the two ends of a colour map.
struct ColourRange {
    double from = 0.0, to = 1.0; ///< from < to

    /// Position on the map, 0 at `from` and 1 at `to`; may lie outside [0, 1].
    double position(double value) const { return (value - from) / (to - from); }
    friend bool operator==(const ColourRange &, const ColourRange &) = default;
};

} // namespace forefront
