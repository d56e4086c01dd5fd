#include "core/drawing_files/svg/drawing/svg_drawer.hpp"
#include "core/drawing_files/svg/xml/svg_elements.hpp"
#include "core/files/text/text_scanner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

// The values that elements give: attributes and properties of style sheets, and what to do with malformed ones.

namespace forefront {

namespace {

/// Returns true for attributes that style sheets can set, too.
bool isGeometry(std::string_view attribute) {
    constexpr std::array kProperties = {"x", "y", "width", "height", "cx", "cy", "r", "rx", "ry"};
    return std::find(kProperties.begin(), kProperties.end(), attribute) != kProperties.end();
}

/// Returns true if a list begins or ends with a comma, or has two between items.
bool hasStrayComma(std::string_view list) {
    bool comma = true;
    for (const char c : list) {
        if (c == ',' && comma) {
            return true;
        }
        comma = c == ',' || (comma && kBlanks.find(c) != kBlanks.npos);
    }
    return comma && !list.empty();
}

} // namespace

/// Returns true if an element gives a value other than "auto" or "none" for a property.
bool SvgDrawer::isGiven(const Visit &visit, const char *property) const {
    const std::string value = styles_.value(visit.node, property);
    return !value.empty() && value != "auto" && value != "none";
}

/// Returns the size of an element's font in user units, which lengths in "em" refer to.
double SvgDrawer::fontSizeOf(const pugi::xml_node &node, double inherited) const {
    return userLength(styles_.value(node, "font-size"), SvgExtent::Width, {inherited, inherited}, inherited)
        .value_or(inherited);
}

/// Returns how an element's stroke is drawn: properties of its own where given and valid, otherwise inherited.
SvgLineStyle SvgDrawer::lineStyleOf(const Visit &visit) const {
    constexpr double kNegative = -std::numeric_limits<double>::infinity();
    SvgLineStyle style = visit.paint.line;
    const auto take = [&](const char *property, double initial, double minimum, double &value) {
        const std::string text = styles_.value(visit.node, property);
        const auto own = text == "initial" ? std::optional(initial) : userStrokeLength(visit, text);
        value = own && *own >= minimum ? *own : value;
    };
    take("stroke-width", SvgLineStyle().width, 0.0, style.width);
    const std::string miter = styles_.value(visit.node, "stroke-miterlimit");
    const auto limit = miter == "initial" ? std::optional(SvgLineStyle().miterLimit) : parseReal(miter); // has no unit
    style.miterLimit = limit && std::isfinite(*limit) && *limit >= 1.0 ? *limit : style.miterLimit;
    take("stroke-dashoffset", 0.0, kNegative, style.dashOffset);
    const std::string dashes = styles_.value(visit.node, "stroke-dasharray");
    if (!dashes.empty() && dashes != "inherit" && dashes != "unset") {
        style.dashes = dashesOf(visit, dashes);
    }
    return style;
}

std::optional<double> SvgDrawer::userStrokeLength(const Visit &visit, std::string_view text) {
    return userLength(text, SvgExtent::Diagonal, visit.viewport, visit.fontSize);
}

/// Returns lengths of dashes and gaps, the list twice if their number is odd; none for "none" and what is malformed.
std::vector<double> SvgDrawer::dashesOf(const Visit &visit, std::string_view text) {
    constexpr std::string_view kSeparators = ", \t\r\n";
    std::vector<double> dashes;
    if (hasStrayComma(text)) {
        return dashes;
    }
    for (std::size_t from = text.find_first_not_of(kSeparators); from != text.npos;) {
        const std::size_t end = std::min(text.find_first_of(kSeparators, from), text.size());
        const auto length = userStrokeLength(visit, text.substr(from, end - from));
        if (!length || *length < 0.0) {
            return {};
        }
        dashes.push_back(*length);
        from = text.find_first_not_of(kSeparators, end);
    }
    if (dashes.size() % 2 != 0) {
        dashes.insert(dashes.end(), dashes.begin(), dashes.end());
    }
    return dashes;
}

/// Returns a length in user units; 0 if it is absent or malformed.
double SvgDrawer::length(const Visit &visit, const char *attribute, SvgExtent extent) {
    return givenLength(visit, attribute, extent).value_or(0.0);
}

/// Returns a length in user units; std::nullopt if it is absent, "auto" or malformed.
std::optional<double> SvgDrawer::givenLength(const Visit &visit, const char *attribute, SvgExtent extent) {
    const std::string text = isGeometry(attribute) ? styles_.value(visit.node, attribute)
                                                   : std::string(visit.node.attribute(attribute).value());
    if (text.find_first_not_of(kBlanks) == std::string::npos || text == "auto") {
        return std::nullopt;
    }
    const auto value = userLength(text, extent, visit.viewport, visit.fontSize);
    if (!value) {
        leaveOut(visit.node, attribute, 0, "bad-number", std::string("invalid length for ") + attribute,
                 inQuotes(text));
    }
    return value;
}

/// Returns the box that percentages and the origin of an element's transform refer to.
Box2 SvgDrawer::transformBox(const Visit &visit) {
    const std::string kind = styles_.value(visit.node, "transform-box");
    const bool own = !kind.empty() && kind != "view-box" && isGiven(visit, "transform");
    const Box2 box = own ? boxOf(visit) : Box2();
    return box.empty() ? viewportBox(visit.viewport) : box;
}

/// Returns the map of an element's own transform, an attribute or a property of CSS; a malformed one is left out.
AffineMap SvgDrawer::transformOf(const pugi::xml_node &node, const Box2 &reference) {
    const std::string text = styles_.valueAsWritten(node, "transform");
    if (text.empty()) {
        return {};
    }
    const auto own = parseTransform(text, reference.size());
    if (!own) {
        leaveOut(node, "transform", 0, "bad-transform", "invalid transform", inQuotes(text));
        return {};
    }
    const std::string origin = styles_.valueAsWritten(node, "transform-origin");
    if (origin.empty()) {
        return *own;
    }
    const auto within = parseTransformOrigin(origin, reference.size());
    if (!within) {
        leaveOut(node, "transform-origin", 0, "bad-transform", "invalid transform-origin", inQuotes(origin));
        return *own;
    }
    const Vec2 centre = reference.min + *within;
    return AffineMap::translation(centre) * *own * AffineMap::translation(Vec2{} - centre);
}

/// Leaves out malformed values, as browsers do: with a warning, or with a fault if the drawing must not be changed. The
/// warning, of which there may be very many, does not contain the value.
void SvgDrawer::leaveOut(const pugi::xml_node &node, const char *attribute, std::size_t within, std::string code,
                         const std::string &message, const std::string &value, std::string_view ignored) {
    if (source_.options.strict) {
        fail(node, attribute, within, std::move(code), message + (value.empty() ? "" : ": " + value),
             "correct the file, or leave out --strict");
    } else if (reports_ && !measuresBox_) {
        source_.warn(code, message + "; " + std::string(ignored) + " is ignored", byteOf(node, attribute, within));
    }
}

/// Returns the byte `within` of an attribute value, or that of the element if it cannot be located in the text.
std::size_t SvgDrawer::byteOf(const pugi::xml_node &node, const char *attribute, std::size_t within) const {
    const std::size_t offset = offsetOf(node);
    const std::string_view text = source_.text;
    std::string_view tag = text.substr(std::min(offset, text.size()));
    tag = tag.substr(0, tag.find('>'));
    const std::string start = std::string(attribute) + '=';
    for (std::size_t at = tag.find(start); *attribute != '\0' && at < tag.size(); at = tag.find(start, at + 1)) {
        if (at > 0 && static_cast<unsigned char>(tag[at - 1]) <= ' ') {
            return std::min(offset + at + start.size() + 1 + within, source_.text.size());
        }
    }
    return offset;
}

} // namespace forefront
