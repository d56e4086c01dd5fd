#include "core/drawing_files/svg/xml/svg_elements.hpp"

#include "core/engine/base/letter_case.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace forefront {

std::string_view localName(const pugi::xml_node &node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

bool isOfSvg(const pugi::xml_node &node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    if (colon == std::string_view::npos || name.substr(0, colon) == "svg") {
        return true;
    }
    constexpr int kDepth = 100; // bounds the time for hostile files
    const std::string declaration = "xmlns:" + std::string(name.substr(0, colon));
    pugi::xml_node at = node;
    for (int depth = 0; at && at.attribute(declaration.c_str()).empty(); ++depth) {
        at = depth < kDepth ? at.parent() : pugi::xml_node();
    }
    const auto isElement = [](const pugi::xml_node &child) { return child.type() == pugi::node_element; };
    const pugi::xml_node declaring = at ? at : node.root().find_child(isElement);
    return std::string_view(declaring.attribute(declaration.c_str()).value()) == "http://www.w3.org/2000/svg";
}

std::string_view hrefOf(const pugi::xml_node &node) {
    const std::string_view plain = node.attribute("href").value();
    if (!plain.empty()) {
        return plain;
    }
    for (const pugi::xml_attribute attribute : node.attributes()) {
        if (std::string_view(attribute.name()).ends_with(":href")) {
            return attribute.value();
        }
    }
    return {};
}

std::size_t offsetOf(const pugi::xml_node &node) {
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
}

std::string_view idOfUrl(std::string_view value) {
    const std::size_t end = value.find(')');
    if (lowerCase(value.substr(0, 4)) != "url(" || end == value.npos) {
        return {};
    }
    constexpr std::string_view kAround = " \t\r\n\"'";
    value = value.substr(4, end - 4);
    const std::size_t first = value.find_first_not_of(kAround);
    value = first == value.npos ? std::string_view() : value.substr(first, value.find_last_not_of(kAround) + 1 - first);
    return value.starts_with('#') ? value.substr(1) : std::string_view();
}

pugi::xml_node targetOf(std::string_view value, const SvgIds &ids) {
    const auto found = ids.find(idOfUrl(value));
    return found == ids.end() ? pugi::xml_node() : found->second;
}

bool isDefinition(std::string_view name) {
    constexpr std::array kDefinitions = {"defs",     "symbol",       "clipPath",       "mask",           "pattern",
                                         "marker",   "style",        "linearGradient", "radialGradient", "filter",
                                         "metadata", "title",        "desc",           "view",           "cursor",
                                         "font",     "meshgradient", "hatch",          "solidColor"};
    return std::find(kDefinitions.begin(), kDefinitions.end(), name) != kDefinitions.end();
}

bool isExcluded(const pugi::xml_node &node) {
    const pugi::xml_attribute languages = node.attribute("systemLanguage");
    bool english = languages.empty();
    std::string_view rest = languages.value();
    while (!english && !rest.empty()) {
        std::string_view word = rest.substr(0, rest.find(','));
        rest.remove_prefix(std::min(word.size() + 1, rest.size()));
        word.remove_prefix(std::min(word.find_first_not_of(kBlanks), word.size()));
        const std::string language = lowerCase(word.substr(0, word.find_first_of("- \t\r\n\f")));
        english = language == "en";
    }
    return !english || !node.attribute("requiredExtensions").empty();
}

bool isAncestor(const pugi::xml_node &outer, const pugi::xml_node &node) {
    constexpr int kDepth = 1000; // bounds the time for hostile files
    pugi::xml_node at = node.parent();
    for (int depth = 0; depth < kDepth && at && at != outer; ++depth) {
        at = at.parent();
    }
    return at == outer;
}

bool isShape(std::string_view name) {
    constexpr std::array kShapes = {"path", "polygon", "polyline", "line", "rect", "circle", "ellipse"};
    return std::find(kShapes.begin(), kShapes.end(), name) != kShapes.end();
}

} // namespace forefront
