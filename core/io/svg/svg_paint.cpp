#include "core/io/svg/svg_paint.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace forefront {

namespace {

bool isGradient(std::string_view name) {
    return name == "linearGradient" || name == "radialGradient";
}

/// Returns true for an element that paints shapes which refer to it.
bool isPaintServer(std::string_view name) {
    return isGradient(name) || name == "pattern" || name == "meshgradient" || name == "hatch" || name == "solidColor";
}

/// Returns true unless renderers paint nothing: all stops of a gradient are transparent, or it has none, or a pattern
/// has no contents. Either may be those of another gradient or pattern, which it refers to.
bool paintsSomething(pugi::xml_node server, const SvgStyles &styles, const SvgIds &ids) {
    constexpr int kDepth = 32; // bounds the time for references in a circle
    const bool gradient = isGradient(localName(server));
    if (!gradient && localName(server) != "pattern") {
        return true;
    }
    const auto isContent = [&](const pugi::xml_node &child) {
        return gradient ? localName(child) == "stop" : child.type() == pugi::node_element;
    };
    const auto shows = [&](const pugi::xml_node &child) {
        return !gradient || (isContent(child) && parseOpacity(styles.value(child, "stop-opacity")) > 0.0 &&
                             parseColour(styles.value(child, "stop-color"), {}).alpha > 0.0);
    };
    for (int depth = 0; depth < kDepth && server; ++depth) {
        if (server.find_child(isContent)) {
            return static_cast<bool>(server.find_child(shows));
        }
        const std::string_view href = hrefOf(server);
        const auto found = href.starts_with('#') ? ids.find(href.substr(1)) : ids.end();
        const bool same = found != ids.end() && isPaintServer(localName(found->second)) &&
                          isGradient(localName(found->second)) == gradient;
        server = same ? found->second : pugi::xml_node();
    }
    return false;
}

/// Returns what a value of `fill` or `stroke` paints: for a reference to nothing that paints, what follows it, or
/// "none".
std::string paintedBy(const pugi::xml_node &node, const char *property, const std::string &value,
                      const SvgStyles &styles, const SvgIds &ids) {
    const std::size_t end = value.find(')');
    if (!value.starts_with("url(") || end == std::string::npos) {
        return value;
    }
    const pugi::xml_node target = targetOf(styles.valueAsWritten(node, property), ids);
    if (isPaintServer(localName(target))) {
        return paintsSomething(target, styles, ids) ? value : "none";
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
