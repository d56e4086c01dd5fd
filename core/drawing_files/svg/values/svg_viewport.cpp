#include "core/drawing_files/svg/values/svg_viewport.hpp"

#include "core/drawing_files/svg/values/svg_pen.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace forefront {

std::optional<SvgLength> parseLength(std::string_view text) {
    SvgNumbers numbers(text);
    SvgLength length;
    if (!numbers.number(length.value)) {
        return std::nullopt;
    }
    length.unit = numbers.unit();
    if (!numbers.atEnd()) {
        return std::nullopt;
    }
    return length;
}

std::optional<double> pixelsPer(std::string_view unit) {
    constexpr double kInch = 96.0;
    constexpr std::pair<std::string_view, double> kUnits[] = {{"", 1.0},
                                                              {"px", 1.0},
                                                              {"in", kInch},
                                                              {"mm", kInch / 25.4},
                                                              {"cm", kInch / 2.54},
                                                              {"q", kInch / 101.6},
                                                              {"pt", kInch / 72.0},
                                                              {"pc", kInch / 6.0}};
    for (const auto &[name, factor] : kUnits) {
        if (unit == name) {
            return factor;
        }
    }
    return std::nullopt;
}

std::string unitName(std::string_view unit) {
    constexpr std::pair<std::string_view, std::string_view> kNames[] = {
        {"in", "inches"}, {"mm", "millimetres"}, {"cm", "centimetres"}, {"q", "quarters of a millimetre"},
        {"pt", "points"}, {"pc", "picas"}};
    const auto *const found =
        std::find_if(std::begin(kNames), std::end(kNames), [&](const auto &name) { return name.first == unit; });
    return std::string(found == std::end(kNames) ? unit : found->second);
}

std::optional<double> userLength(std::string_view text, SvgExtent extent, Vec2 viewport, double fontSize) {
    const auto length = parseLength(text);
    if (!length) {
        return std::nullopt;
    }
    if (length->unit == "%") {
        const double whole = extent == SvgExtent::Width    ? viewport.x
                             : extent == SvgExtent::Height ? viewport.y
                                                           : std::sqrt(0.5 * lengthSquared(viewport));
        return whole > 0.0 ? std::optional(length->value / 100.0 * whole) : std::nullopt;
    }
    const bool half = length->unit == "ex" || length->unit == "ch"; // CSS: half an em where the font is unknown
    const auto factor = half                    ? std::optional(0.5 * fontSize)
                        : length->unit == "em"  ? std::optional(fontSize)
                        : length->unit == "rem" ? std::optional(kMediumFont)
                                                : pixelsPer(length->unit);
    return factor ? std::optional(*factor * length->value) : std::nullopt;
}

std::optional<ViewBox> parseViewBox(std::string_view text) {
    SvgNumbers numbers(text);
    ViewBox box;
    const bool sound = numbers.point(box.corner) && numbers.point(box.size) && box.size.x > 0.0 && box.size.y > 0.0;
    return sound ? std::optional(box) : std::nullopt;
}

AffineMap viewBoxMap(const ViewBox &box, Vec2 size, std::string_view preserveAspectRatio) {
    Vec2 scale{size.x / box.size.x, size.y / box.size.y};
    Vec2 share{0.5, 0.5}; // fraction of the free space before the box
    const bool keeps = preserveAspectRatio.find("none") == std::string_view::npos;
    if (keeps) {
        const bool slice = preserveAspectRatio.find("slice") != std::string_view::npos;
        const double factor = slice ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y);
        scale = {factor, factor};
        const auto part = [&](std::string_view minimum, std::string_view maximum) {
            return preserveAspectRatio.find(minimum) != std::string_view::npos   ? 0.0
                   : preserveAspectRatio.find(maximum) != std::string_view::npos ? 1.0
                                                                                 : 0.5;
        };
        share = {part("xMin", "xMax"), part("YMin", "YMax")};
    }
    return {scale.x,
            0.0,
            0.0,
            scale.y,
            share.x * (size.x - scale.x * box.size.x) - scale.x * box.corner.x,
            share.y * (size.y - scale.y * box.size.y) - scale.y * box.corner.y};
}

} // namespace forefront
