#include "core/drawing_files/svg/style/svg_notes.hpp"

#include "core/drawing_files/svg/xml/svg_elements.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

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

void notePaint(const SourceText &source, const SvgPaint &paint, const pugi::xml_node &node) {
    const bool fills = paint.fillAlpha() > 0.0, strokes = source.options.strokeAreas && paint.strokeAlpha() > 0.0;
    if ((fills && paint.patterned) || (strokes && paint.strokePatterned)) {
        source.note("svg-pattern", "patterns count as a solid fill, without the gaps between their parts",
                    offsetOf(node));
    }
    if ((fills && paint.faded) || (strokes && paint.strokeFaded)) {
        source.note("svg-gradient", "gradients that fade to transparent count as a solid fill", offsetOf(node));
    }
}

namespace {

/// What a drawing holds that is not shown, or has no outline.
struct Unshown {
    std::size_t defined = 0; ///< shapes in symbols and definitions
    std::size_t glyphs = 0;
    bool text = false;
    bool used = false; ///< there is a <use>
};

Unshown unshownIn(const pugi::xml_node &root) {
    Unshown found;
    std::vector<std::pair<pugi::xml_node, bool>> open = {{root, false}}; // and if a <use> could show it
    while (!open.empty()) {
        auto [node, usable] = open.back();
        open.pop_back();
        const std::string_view name = localName(node);
        usable = isDefinition(name) ? name == "symbol" || name == "defs" : usable;
        found.defined += usable && isShape(name) ? 1 : 0;
        found.glyphs += name == "glyph" && node.attribute("d") ? 1 : 0;
        found.text = found.text || name == "text";
        found.used = found.used || name == "use";
        for (const pugi::xml_node child : node.children()) {
            open.emplace_back(child, usable);
        }
    }
    return found;
}

} // namespace

Diagnostic nothingDrawn(const SourceText &source, const pugi::xml_node &root) {
    const Unshown unshown = unshownIn(root);
    std::string reason, advice;
    if (unshown.text) {
        advice = "convert its text to paths";
    } else if (unshown.defined > 0 && !unshown.used) {
        reason = ": its " + countText(unshown.defined, "shape") + (unshown.defined == 1 ? " is" : " are") +
                 " in symbols or definitions that nothing uses";
        advice = "draw them with <use>, or move them out of <symbol> and <defs>";
    } else if (unshown.glyphs > 0) {
        reason = ": its " + countText(unshown.glyphs, "glyph") + (unshown.glyphs == 1 ? " is" : " are") + " of a font";
        advice = "write text in this font, and convert it to paths in the drawing program";
    }
    return faultAt(source, offsetOf(root), "empty-domain",
                   "the drawing holds no path that could bound a domain" + reason, advice);
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
