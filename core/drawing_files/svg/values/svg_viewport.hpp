#pragma once

#include "core/drawing_files/svg/values/svg_transform.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace forefront {

/// A length as SVG writes it.
struct SvgLength {
    double value = 0.0;
    std::string unit; ///< in lower case: "", "px", "mm", "%", ...
};

/// Returns the number and unit of a length; std::nullopt if it is malformed.
std::optional<SvgLength> parseLength(std::string_view text);

/// Returns the number of user units (pixels, 96 per inch) in one of that unit; std::nullopt for "%", units of the font,
/// and unknown units.
std::optional<double> pixelsPer(std::string_view unit);

/// Returns the name of a unit in the plural, such as "inches" for "in"; returns unknown units unchanged.
std::string unitName(std::string_view unit);

/// The extent of the viewport that a percentage refers to.
enum class SvgExtent { Width, Height, Diagonal };

constexpr double kMediumFont = 16.0; ///< the size of a font where none is given, in user units

/// Returns the box of a viewport, from the origin.
inline Box2 viewportBox(Vec2 size) {
    return {{0.0, 0.0}, size};
}

/// Returns a length in user units, with percentages relative to the viewport, and "em" and "ex" to the font size;
/// std::nullopt if it is malformed or its unit is unknown.
std::optional<double> userLength(std::string_view text, SvgExtent extent, Vec2 viewport, double fontSize = kMediumFont);

/// The rectangle of user space that an attribute `viewBox` names.
struct ViewBox {
    Vec2 corner, size;
};
/// Returns the view box; std::nullopt if it is absent, malformed or empty.
std::optional<ViewBox> parseViewBox(std::string_view text);

/// Returns the map from a view box to the rectangle from the origin to `size`, by the rules of `preserveAspectRatio`.
AffineMap viewBoxMap(const ViewBox &box, Vec2 size, std::string_view preserveAspectRatio);

} // namespace forefront
