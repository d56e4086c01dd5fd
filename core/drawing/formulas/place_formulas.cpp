#include "core/drawing/formulas/place_formulas.hpp"

#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/shapes/plane_map.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/parts/expression/expression_parser.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {
namespace {

bool hasAny(std::string_view text, std::string_view characters) {
    return text.find_first_of(characters) != std::string_view::npos;
}

/// Returns an expression that can be a summand: choices and comparisons in parentheses.
std::string summand(const std::string &text) {
    return hasAny(text, "?:<>=!&|") ? '(' + text + ')' : text;
}

/// Returns an expression that can be a factor: sums in parentheses.
std::string factor(const std::string &text) {
    return hasAny(text, "+-?:<>=!&|") ? '(' + text + ')' : text;
}

std::string formulaOr(const Document &document, NodeRef handle, Quantity axis, double value) {
    const auto found = document.formulas.find({NumberOwner::ofShape(handle.shape), axis, handle.node});
    return found != document.formulas.end() ? found->second : exactText(value);
}

/// Returns a length times the cosine or sine of an angle.
std::string component(const std::string &length, const std::string &degrees, bool across) {
    const std::optional<double> size = plainNumber(length), angle = plainNumber(degrees);
    if (angle) {
        const Vec2 way = unitVector(*angle);
        const double part = across ? way.x : way.y;
        if (size) {
            return exactText(*size * part);
        }
        if (part == 0.0 || std::fabs(part) == 1.0) {
            return part == 0.0 ? "0" : part > 0.0 ? length : '-' + factor(length);
        }
        constexpr double kPlaces = 1e4, kPartRounding = 1e-15; // 0.6 and 0.8 rather than an angle of 53.13...
        if (const double few = std::round(part * kPlaces) / kPlaces; std::fabs(few - part) <= kPartRounding) {
            return (few < 0.0 ? "-" : "") + factor(length) + '*' + exactText(std::fabs(few));
        }
    }
    return factor(length) + (across ? "*cos(" : "*sin(") + factor(degrees) + "*pi/180)";
}

} // namespace

std::optional<double> plainNumber(std::string_view text) {
    double value = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = fault == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt; // a parameter may be called "inf"
}

PlaceFormula placeFormula(Vec2 at) {
    return {exactText(at.x), exactText(at.y)};
}

PlaceFormula placeFormula(const Document &document, NodeRef handle) {
    const Vec2 at = handlesOf(*findShape(document, handle.shape))[handle.node];
    return {formulaOr(document, handle, Quantity::X, at.x), formulaOr(document, handle, Quantity::Y, at.y)};
}

std::string sumFormula(const std::string &a, const std::string &b) {
    const std::optional<double> left = plainNumber(a), right = plainNumber(b);
    if (left && right) {
        return exactText(*left + *right);
    }
    if (left == 0.0 || right == 0.0) {
        return left == 0.0 ? b : a;
    }
    const std::string second = summand(b);
    return second.starts_with('-') ? summand(a) + " - " + second.substr(1) : summand(a) + " + " + second;
}

std::string differenceFormula(const std::string &a, const std::string &b) {
    const std::optional<double> right = plainNumber(b);
    return sumFormula(a, right ? exactText(-*right) : '-' + factor(b));
}

std::string degreesText(Vec2 direction) {
    const double degrees = std::atan2(direction.y, direction.x) * 180.0 / std::numbers::pi;
    constexpr double kRounding = 5e-13;
    const double whole = std::round(degrees);
    return exactText(std::fabs(degrees - whole) <= kRounding ? whole + 0.0 : degrees);
}

PlaceFormula polarFormula(const PlaceFormula &from, const std::string &distance, const std::string &degrees) {
    return {sumFormula(from.x, component(distance, degrees, true)),
            sumFormula(from.y, component(distance, degrees, false))};
}

bool usesNames(const std::string &text) {
    const std::vector<std::string_view> names = namesIn(text);
    return !std::all_of(names.begin(), names.end(), isReservedName);
}

Document followLength(Document document, SegmentRef segment, const std::string &length) {
    const Shape *const shape = findShape(document, segment.shape);
    if (shape == nullptr || !usesNames(length)) {
        return document;
    }
    const std::vector<Vec2> handles = handlesOf(*shape);
    const auto end = static_cast<std::uint32_t>((segment.segment + 1) % handles.size());
    const NodeRef first{segment.shape, segment.segment};
    const PlaceFormula place =
        polarFormula(placeFormula(document, first), length, degreesText(handles[end] - handles[segment.segment]));
    for (const auto &[axis, text] : {std::pair(Quantity::X, place.x), std::pair(Quantity::Y, place.y)}) {
        if (usesNames(text)) {
            document = setFormula(std::move(document), {NumberOwner::ofShape(segment.shape), axis, end}, text);
        }
    }
    return document;
}

} // namespace forefront
