#include "core/drawing_files/svg/style/svg_paint.hpp"

#include "core/engine/base/letter_case.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

namespace {

bool isGradient(std::string_view name) {
    return name == "linearGradient" || name == "radialGradient";
}

/// Returns true for an element that paints the shapes that refer to it.
bool isPaintServer(std::string_view name) {
    const std::string lower = lowerCase(name); // drafts of the standard spell some of them in different ways
    return isGradient(name) || name == "pattern" || lower == "meshgradient" || lower == "hatch" ||
           lower == "solidcolor";
}

/// Returns true if a child of a gradient or pattern is one of its stops or a part of its contents.
bool isContent(const pugi::xml_node &child) {
    return isGradient(localName(child.parent())) ? localName(child) == "stop" : child.type() == pugi::node_element;
}

/// Returns the end that a value of `stroke-linecap` names; std::nullopt if it is invalid.
std::optional<SvgCap> capOf(std::string_view cap) {
    return cap == "butt" || cap == "initial" ? std::optional(SvgCap::Butt)
           : cap == "round"                  ? std::optional(SvgCap::Round)
           : cap == "square"                 ? std::optional(SvgCap::Square)
                                             : std::nullopt;
}

/// Returns the corner that a value of `stroke-linejoin` names; std::nullopt if it is invalid. "arcs" and "miter-clip",
/// which few programs draw, are miters.
std::optional<BandCorner> cornerOf(std::string_view join) {
    const bool miter = join == "miter" || join == "miter-clip" || join == "arcs" || join == "initial";
    return miter             ? std::optional(BandCorner::Miter)
           : join == "round" ? std::optional(BandCorner::Round)
           : join == "bevel" ? std::optional(BandCorner::Bevel)
                             : std::nullopt;
}

} // namespace

/// Returns the gradient or pattern that another one takes its stops or contents from; null if there is none.
pugi::xml_node SvgPaintServers::origin(const pugi::xml_node &server) const {
    const std::string_view href = hrefOf(server), name = localName(server);
    const auto found = href.starts_with('#') ? ids_.find(href.substr(1)) : ids_.end();
    if (found == ids_.end()) {
        return {};
    }
    const std::string_view other = localName(found->second);
    return (isGradient(name) && isGradient(other)) || name == other ? found->second : pugi::xml_node();
}

SvgPaintServers::Coverage SvgPaintServers::coverageOf(pugi::xml_node server) {
    if (!isGradient(localName(server)) && localName(server) != "pattern") {
        return Coverage::Everything;
    }
    std::vector<std::size_t> asked;
    Coverage result = Coverage::Nothing;
    for (; server; server = origin(server)) {
        const auto [known, added] = known_.try_emplace(server.hash_value(), Coverage::Nothing);
        if (!added) { // or references in a circle
            result = known->second;
            break;
        }
        asked.push_back(server.hash_value());
        if (server.find_child(isContent)) {
            result = isGradient(localName(server)) ? coverageOfStops(server) : Coverage::Everything;
            break;
        }
    }
    for (const std::size_t one : asked) {
        known_[one] = result;
    }
    return result;
}

SvgPaintServers::Coverage SvgPaintServers::coverageOfStops(const pugi::xml_node &gradient) const {
    constexpr double kFaint = 0.05; // maximum opacity that is hardly seen
    double minimum = 1.0, maximum = 0.0;
    for (const pugi::xml_node child : gradient.children()) {
        if (isContent(child)) {
            const double alpha = parseOpacity(styles_.value(child, "stop-opacity")) *
                                 parseColour(styles_.value(child, "stop-color"), {}).alpha;
            minimum = std::min(minimum, alpha);
            maximum = std::max(maximum, alpha);
        }
    }
    return !(maximum > 0.0)                        ? Coverage::Nothing
           : minimum <= kFaint && maximum > kFaint ? Coverage::Parts
                                                   : Coverage::Everything;
}

bool SvgPaintServers::fades(const pugi::xml_node &node, const char *property) {
    const pugi::xml_node target = targetOf(styles_.valueAsWritten(node, property), ids_);
    return isGradient(localName(target)) && coverageOf(target) == Coverage::Parts;
}

std::string SvgPaintServers::paintedBy(const pugi::xml_node &node, const char *property, const std::string &value) {
    const std::size_t end = value.find(')');
    if (!value.starts_with("url(") || end == std::string::npos) {
        return value;
    }
    const pugi::xml_node target = targetOf(styles_.valueAsWritten(node, property), ids_);
    if (isPaintServer(localName(target))) {
        return coverageOf(target) == Coverage::Nothing ? "none" : value;
    }
    const std::size_t fallback = value.find_first_not_of(kBlanks, end + 1);
    return fallback == std::string::npos ? "none" : value.substr(fallback);
}

SvgPaint paintOf(const pugi::xml_node &node, SvgPaintServers &servers, const SvgPaint &inherited) {
    const SvgStyles &styles = servers.styles();
    SvgPaint paint = inherited;
    const auto take = [&](const char *property, const auto &use) {
        if (const std::string value = styles.value(node, property);
            !value.empty() && value != "inherit" && value != "unset") {
            use(value);
        }
    };
    const auto isPattern = [&](const char *property) {
        return localName(targetOf(styles.valueAsWritten(node, property), servers.ids())) == "pattern";
    };
    take("color", [&](const std::string &value) { paint.current = parseColour(value, inherited.current); });
    take("fill", [&](const std::string &given) {
        const std::string value = servers.paintedBy(node, "fill", given);
        paint.filled = value != "none";
        paint.fillGiven = true;
        paint.patterned = isPattern("fill");
        paint.faded = servers.fades(node, "fill");
        paint.fill = parseColour(value, paint.current);
    });
    take("stroke", [&](const std::string &given) {
        const std::string value = servers.paintedBy(node, "stroke", given);
        paint.stroked = value != "none";
        paint.strokePatterned = isPattern("stroke");
        paint.strokeFaded = servers.fades(node, "stroke");
        paint.stroke = parseColour(value, paint.current);
    });
    const auto ruleOf = [](const std::string &value) {
        return value == "evenodd" ? FillRule::EvenOdd : FillRule::NonZero;
    };
    take("fill-rule", [&](const std::string &value) { paint.rule = ruleOf(value); });
    take("clip-rule", [&](const std::string &value) { paint.clipRule = ruleOf(value); });
    take("fill-opacity", [&](const std::string &value) { paint.fillOpacity = parseOpacity(value); });
    take("stroke-opacity", [&](const std::string &value) { paint.strokeOpacity = parseOpacity(value); });
    take("stroke-linecap", [&](const std::string &value) { paint.line.cap = capOf(value).value_or(paint.line.cap); });
    take("stroke-linejoin",
         [&](const std::string &value) { paint.line.corner = cornerOf(value).value_or(paint.line.corner); });
    take("opacity", [&](const std::string &value) { paint.opacity *= parseOpacity(value); });
    return paint;
}

} // namespace forefront
