#include "core/io/svg/svg_notes.hpp"

#include "core/io/svg/svg_elements.hpp"

namespace forefront {

void noteUnusedStyle(const SourceText &source, const SvgStyles &styles, const pugi::xml_node &node) {
    const auto given = [&](const char *property) {
        const std::string value = styles.value(node, property);
        return !value.empty() && value != "none";
    };
    // The attribute is read; the property of CSS, which overrides it, is not.
    const bool attribute = !node.attribute("transform").empty();
    const bool inStyle = std::string_view(node.attribute("style").value()).find("transform") != std::string_view::npos;
    if (given("transform") && (!attribute || inStyle)) {
        source.note("svg-css-transform", "CSS transforms are ignored; use the transform attribute", offsetOf(node));
    }
    for (const pugi::xml_node child : node.children()) {
        const std::string_view name = localName(child);
        if (name.starts_with("animate") || name == "set") {
            source.note("svg-animation", "animations are ignored: the drawing is read in its initial state",
                        offsetOf(child));
        }
    }
}

std::string whyIgnored(std::string_view name) {
    if (name == "text" || name == "tspan" || name == "textPath") {
        return ": text has no outline; convert it to paths in the drawing program";
    }
    return name == "image"           ? ": images have no outline; trace them in the drawing program"
           : name == "foreignObject" ? ": it holds no SVG"
                                     : ": it is not a shape";
}

} // namespace forefront
