#pragma once

#include "core/drawing_files/svg/values/svg_viewport.hpp"
#include "core/engine/base/length_unit.hpp"
#include "core/engine/base/vec2.hpp"

#include <pugixml.hpp>

#include <optional>
#include <string>

namespace forefront {

/// The map from drawing coordinates to domain coordinates.
struct SvgAxes {
    AffineMap map;    ///< from user space to the domain
    Vec2 viewport;    ///< size of the outermost viewport in user units; 0 if unknown
    std::string unit; ///< "mm" or the like, if the document's size changes the unit of coordinates
    LengthUnit lengthUnit = LengthUnit::None; ///< of coordinates, if the document's size is given in one
    std::optional<ViewBox> page = {};         ///< the visible area, in user units; absent if the document gives no size
};

/// Returns the axes of the root element. The y axis of a domain points up, so the drawing is flipped within its view
/// box. If the document's size is given in millimetres or the like, so are the coordinates.
SvgAxes axesOf(const pugi::xml_node &root);

} // namespace forefront
