#pragma once

#include "core/arrangement/arrangement.hpp"
#include "core/io/svg/svg_colour.hpp"
#include "core/io/svg/svg_css.hpp"
#include "core/io/svg/svg_elements.hpp"

#include <pugixml.hpp>

namespace forefront {

/// Fill and stroke of a shape.
struct SvgPaint {
    bool filled = true;
    bool fillGiven = false; ///< the drawing states the fill
    bool patterned = false; ///< the fill is a pattern
    bool stroked = false;
    FillRule rule = FillRule::NonZero;
    FillRule clipRule = FillRule::NonZero; ///< the rule that applies instead inside a clip path
    SvgColour fill, stroke;
    SvgColour current; ///< the property `color`
    double fillOpacity = 1.0, strokeOpacity = 1.0;
    double opacity = 1.0; ///< product of those of the element and all elements around it

    /// Returns the opacity of the fill; 0: nothing is filled.
    double fillAlpha() const { return filled ? fill.alpha * fillOpacity * opacity : 0.0; }
    double strokeAlpha() const { return stroked ? stroke.alpha * strokeOpacity * opacity : 0.0; }
};

/// Returns the paint of an element: its own where given, otherwise inherited. A gradient or pattern that `ids` does not
/// hold is replaced by its fallback; one without stops or contents paints nothing.
SvgPaint paintOf(const pugi::xml_node &node, const SvgStyles &styles, const SvgIds &ids, const SvgPaint &inherited);

} // namespace forefront
