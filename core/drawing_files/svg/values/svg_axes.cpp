#include "core/drawing_files/svg/values/svg_axes.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

namespace forefront {

namespace {

bool isPhysical(const std::optional<SvgLength> &length) {
    return length && length->value > 0.0 && length->unit != "px" && length->unit != "" && pixelsPer(length->unit);
}

double pixels(const std::optional<SvgLength> &length) {
    return length ? length->value * pixelsPer(length->unit).value_or(0.0) : 0.0;
}

/// Returns the size of a user unit in the unit of `width`.
Vec2 physicalScale(const ViewBox &box, const SvgLength &width, const std::optional<SvgLength> &height,
                   std::string_view preserveAspectRatio) {
    Vec2 scale;
    scale.x = width.value / box.size.x;
    const double tall = !isPhysical(height)          ? scale.x * box.size.y
                        : height->unit == width.unit ? height->value
                                                     : pixels(height) / *pixelsPer(width.unit);
    scale.y = tall / box.size.y;
    if (preserveAspectRatio.find("none") == std::string_view::npos) {
        const bool slice = preserveAspectRatio.find("slice") != std::string_view::npos;
        scale.x = scale.y = slice ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y);
    }
    return scale;
}

/// Returns the part of user space that a view box shows in a document of that size: more than the box where the
/// proportions differ, and less with "slice".
ViewBox shown(const ViewBox &box, Vec2 size, std::string_view preserveAspectRatio) {
    if (!(size.x > 0.0 && size.y > 0.0)) {
        return box;
    }
    const AffineMap map = viewBoxMap(box, size, preserveAspectRatio);
    return {{-map.e / map.a, -map.f / map.d}, {size.x / map.a, size.y / map.d}};
}

} // namespace

SvgAxes axesOf(const pugi::xml_node &root) {
    const auto width = parseLength(root.attribute("width").value());
    const auto height = parseLength(root.attribute("height").value());
    SvgAxes axes;
    axes.map = AffineMap{1, 0, 0, -1, 0, 0};
    Vec2 scale{1.0, 1.0};
    if (const auto box = parseViewBox(root.attribute("viewBox").value())) {
        axes.map.f = 2.0 * box->corner.y + box->size.y;
        axes.viewport = box->size;
        axes.page = shown(*box, {pixels(width), pixels(height)}, root.attribute("preserveAspectRatio").value());
        if (isPhysical(width)) {
            scale = physicalScale(*box, *width, height, root.attribute("preserveAspectRatio").value());
        }
    } else {
        axes.viewport = {pixels(width), pixels(height)};
        axes.map.f = axes.viewport.y;
        if (axes.viewport.x > 0.0 && axes.viewport.y > 0.0) {
            axes.page = ViewBox{{}, axes.viewport};
        }
        scale.x = scale.y = isPhysical(width) ? 1.0 / *pixelsPer(width->unit) : 1.0;
    }
    axes.map = AffineMap{scale.x, 0, 0, scale.y, 0, 0} * axes.map;
    if (isPhysical(width)) {
        axes.lengthUnit = fromWord<LengthUnit>(width->unit).value_or(LengthUnit::None);
    }
    if (scale.x != 1.0) {
        axes.unit = width->unit;
    }
    return axes;
}

} // namespace forefront
