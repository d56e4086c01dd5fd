#include "core/io/svg/svg_paint.hpp"

#include <string>

namespace forefront {

SvgPaint paintOf(const pugi::xml_node &node, const SvgStyles &styles, const SvgPaint &inherited) {
    const auto given = [&](const char *property) {
        const std::string value = styles.value(node, property);
        return value == "inherit" ? std::string() : value;
    };
    const auto paints = [](const std::string &value) { return value != "none" && value != "transparent"; };
    SvgPaint paint = inherited;
    if (const std::string fill = given("fill"); !fill.empty()) {
        paint.filled = paints(fill);
        paint.fillGiven = true;
    }
    if (const std::string stroke = given("stroke"); !stroke.empty()) {
        paint.stroked = paints(stroke);
    }
    if (const std::string rule = given("fill-rule"); !rule.empty()) {
        paint.rule = rule == "evenodd" ? FillRule::EvenOdd : FillRule::NonZero;
    }
    return paint;
}

} // namespace forefront
