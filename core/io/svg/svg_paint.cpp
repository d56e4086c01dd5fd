#include "core/io/svg/svg_paint.hpp"

#include <cstddef>
#include <string>

namespace forefront {

namespace {

/// Returns what a value of `fill` or `stroke` paints: for a reference to nothing, what follows it, or "none".
std::string paintedBy(const pugi::xml_node &node, const char *property, const std::string &value,
                      const SvgStyles &styles, const SvgIds &ids) {
    const std::size_t end = value.find(')');
    if (!value.starts_with("url(") || end == std::string::npos ||
        targetOf(styles.valueAsWritten(node, property), ids)) {
        return value;
    }
    const std::size_t fallback = value.find_first_not_of(kBlanks, end + 1);
    return fallback == std::string::npos ? "none" : value.substr(fallback);
}

} // namespace

SvgPaint paintOf(const pugi::xml_node &node, const SvgStyles &styles, const SvgIds &ids, const SvgPaint &inherited) {
    SvgPaint paint = inherited;
    const auto take = [&](const char *property, const auto &use) {
        if (const std::string value = styles.value(node, property); !value.empty() && value != "inherit") {
            use(value);
        }
    };
    take("color", [&](const std::string &value) { paint.current = parseColour(value, inherited.current); });
    take("fill", [&](const std::string &given) {
        const std::string value = paintedBy(node, "fill", given, styles, ids);
        paint.filled = value != "none";
        paint.fillGiven = true;
        paint.patterned = localName(targetOf(styles.valueAsWritten(node, "fill"), ids)) == "pattern";
        paint.fill = parseColour(value, paint.current);
    });
    take("stroke", [&](const std::string &given) {
        const std::string value = paintedBy(node, "stroke", given, styles, ids);
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
