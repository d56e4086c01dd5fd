#include "core/io/svg/svg_paint.hpp"

#include <string>

namespace forefront {

SvgPaint paintOf(const pugi::xml_node &node, const SvgStyles &styles, const SvgPaint &inherited) {
    SvgPaint paint = inherited;
    const auto take = [&](const char *property, const auto &use) {
        if (const std::string value = styles.value(node, property); !value.empty() && value != "inherit") {
            use(value);
        }
    };
    take("color", [&](const std::string &value) { paint.current = parseColour(value, inherited.current); });
    take("fill", [&](const std::string &value) {
        paint.filled = value != "none";
        paint.fillGiven = true;
        paint.fill = parseColour(value, paint.current);
    });
    take("stroke", [&](const std::string &value) {
        paint.stroked = value != "none";
        paint.stroke = parseColour(value, paint.current);
    });
    const auto ruleOf = [](const std::string &value) {
        return value == "evenodd" ? FillRule::EvenOdd : FillRule::NonZero;
    };
    take("fill-rule", [&](const std::string &value) { paint.rule = ruleOf(value); });
    take("clip-rule", [&](const std::string &value) { paint.clipRule = ruleOf(value); });
    take("fill-opacity", [&](const std::string &value) { paint.fillOpacity = parseOpacity(value); });
    take("stroke-opacity", [&](const std::string &value) { paint.strokeOpacity = parseOpacity(value); });
    take("opacity", [&](const std::string &value) { paint.opacity *= parseOpacity(value); });
    return paint;
}

} // namespace forefront
