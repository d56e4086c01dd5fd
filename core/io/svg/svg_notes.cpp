#include "core/io/svg/svg_notes.hpp"

#include "core/io/svg/svg_elements.hpp"

#include <algorithm>
#include <array>

namespace forefront {

void noteUnusedStyle(const SourceText &source, const SvgStyles &styles, const SvgIds &ids, const pugi::xml_node &node) {
    const auto given = [&](const char *property) {
        const std::string value = styles.value(node, property);
        return !value.empty() && value != "none";
    };
    constexpr std::array kMoving = {"rotate", "scale", "translate", "offset-path"};
    const bool moves = std::any_of(kMoving.begin(), kMoving.end(), [&](const char *property) {
        return node.attribute(property).empty() && given(property); // attributes of these names mean something else
    });
    if (moves) {
        source.note("svg-css-transform",
                    "the properties rotate, scale, translate and offset-path are ignored; use transform",
                    offsetOf(node));
    }
    constexpr std::array kMarkers = {"marker", "marker-start", "marker-mid", "marker-end"};
    const bool marked = std::any_of(kMarkers.begin(), kMarkers.end(), [&](const char *property) {
        const bool shorthand = std::string_view(property) == "marker"; // not known as an attribute
        return !(shorthand && !node.attribute(property).empty()) &&
               localName(targetOf(styles.valueAsWritten(node, property), ids)) == "marker";
    });
    constexpr std::array<std::string_view, 4> kWithoutMarkers = {"rect", "circle", "ellipse", "image"};
    if (marked && std::find(kWithoutMarkers.begin(), kWithoutMarkers.end(), localName(node)) == kWithoutMarkers.end()) {
        source.note("svg-marker", "markers, such as arrowheads, are ignored; convert them to paths", offsetOf(node));
    }
    if (given("filter")) {
        source.note("svg-filter", "filters, such as shadows and blurs, are ignored: shapes end at their outlines",
                    offsetOf(node));
    }
    for (const pugi::xml_node child : node.children()) {
        const std::string_view name = localName(child);
        if (name.starts_with("animate") || name == "set") {
            source.note("svg-animation", "animations are ignored: the drawing is read in its initial state",
                        offsetOf(child));
        }
    }
}

void noteFill(const SourceText &source, const SvgPaint &paint, const pugi::xml_node &node) {
    if (!(paint.fillAlpha() > 0.0)) {
        return;
    }
    if (paint.patterned) {
        source.note("svg-pattern", "patterns count as a solid fill, without the gaps between their parts",
                    offsetOf(node));
    }
    if (paint.faded) {
        source.note("svg-gradient", "gradients that fade to transparent count as a solid fill", offsetOf(node));
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
