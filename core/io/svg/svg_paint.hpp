#pragma once

#include "core/arrangement/arrangement.hpp"
#include "core/io/svg/svg_css.hpp"

#include <pugixml.hpp>

namespace forefront {

/// Fill and stroke of a shape.
struct SvgPaint {
    bool filled = true;
    bool fillGiven = false; ///< the drawing states the fill
    bool stroked = false;
    FillRule rule = FillRule::NonZero;
};

/// Returns the fill, stroke and fill rule of an element: its own where given, otherwise inherited.
SvgPaint paintOf(const pugi::xml_node &node, const SvgStyles &styles, const SvgPaint &inherited);

} // namespace forefront
