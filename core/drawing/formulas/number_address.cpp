#include "core/drawing/formulas/number_address.hpp"

#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/formulas/source_numbers.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/shapes/slot.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "core/engine/spacing/spec/spec_check.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {
namespace {

using Owner = NumberAddress::Owner;

constexpr std::array<std::pair<std::string_view, Owner>, 4> kOwners{
    {{"shape", Owner::Shape}, {"source", Owner::Source}, {"region", Owner::Region}, {"part", Owner::Part}}};

/// Returns true if the address ends in the index of a handle.
bool hasHandle(const NumberAddress &address) {
    const std::string &what = address.quantity;
    return address.owner == Owner::Shape &&
           (what == "x" || what == "y" || what == "size" || what == "growth" || what == "arcRadius");
}

std::optional<double> copied(const double *place) {
    return place != nullptr ? std::optional(*place) : std::nullopt;
}

std::vector<std::string_view> pieces(std::string_view text) {
    std::vector<std::string_view> list;
    while (true) {
        const std::size_t end = text.find('/');
        list.push_back(text.substr(0, end));
        if (end == std::string_view::npos) {
            return list;
        }
        text.remove_prefix(end + 1);
    }
}

std::optional<std::uint32_t> parseIndex(std::string_view text) {
    std::uint32_t value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

template <class Part>
auto partNumber(Part &part, const std::string &what) -> decltype(&part.size) {
    return what == "size" ? &part.size : what == "growth" ? &part.growth : nullptr;
}

std::optional<double> shapeNumber(const Shape &shape, const NumberAddress &address) {
    const std::string &what = address.quantity;
    const std::vector<Vec2> handles = handlesOf(shape);
    if (what == "x" || what == "y") {
        if (address.handle >= handles.size()) {
            return std::nullopt;
        }
        return what == "x" ? handles[address.handle].x : handles[address.handle].y;
    }
    if (what == "size" || what == "growth") {
        const auto part = shape.nodeSizes.find(address.handle);
        return part != shape.nodeSizes.end() ? copied(partNumber(part->second, what)) : std::nullopt;
    }
    if (what == "arcRadius") {
        const bool arc = isPath(shape) && address.handle < shape.curves.size();
        return arc ? radiusOf(shape.curves[address.handle]) : std::nullopt;
    }
    if (what == "radius" && (shape.kind == ShapeKind::Circle || shape.kind == ShapeKind::Rectangle)) {
        return shape.kind == ShapeKind::Rectangle ? shape.radius : circleRadius(shape);
    }
    if (shape.kind == ShapeKind::Ellipse && (what == "rx" || what == "ry")) {
        return distance(handles[0], handles[what == "rx" ? 1 : 2]);
    }
    if (shape.kind == ShapeKind::Slot && (what == "width" || what == "length")) {
        return what == "width" ? 2.0 * shape.radius : distance(handles[0], handles[1]);
    }
    if (shape.kind == ShapeKind::Rectangle) {
        const Box2 box = boundsOf(shape);
        const std::array<std::pair<std::string_view, double>, 4> numbers{
            {{"left", box.min.x}, {"bottom", box.min.y}, {"width", box.size().x}, {"height", box.size().y}}};
        for (const auto &[name, value] : numbers) {
            if (what == name) {
                return value;
            }
        }
    }
    return std::nullopt;
}

/// Returns a rectangle with one of its four numbers changed.
Shape changedBox(Shape shape, const std::string &what, double value) {
    const Box2 box = boundsOf(shape);
    Vec2 low = box.min, size = box.size();
    (what == "left" ? low.x : what == "bottom" ? low.y : what == "width" ? size.x : size.y) = value;
    placeBox(shape, low, low + size);
    shape.cuts.clear();
    return shape;
}

/// Sets a number of a shape, which may become degenerate.
Status setShapeNumber(Shape &shape, const NumberAddress &address, double value) {
    const std::string &what = address.quantity;
    if (what == "x" || what == "y") {
        const Vec2 at = handlesOf(shape)[address.handle];
        placeHandle(shape, address.handle, what == "x" ? Vec2{value, at.y} : Vec2{at.x, value});
        return {};
    }
    if (what == "size" || what == "growth") {
        *partNumber(shape.nodeSizes.at(address.handle), what) = value;
        return {};
    }
    const bool circle = shape.kind == ShapeKind::Circle;
    const bool extent = circle || what == "width" || what == "height" || what == "rx" || what == "ry" ||
                        what == "length" || what == "arcRadius";
    if (extent && !(value > 0.0)) {
        return error("bad-number", "invalid " + what + " of " + displayName(shape) + "; expected a number above 0");
    }
    if (what == "arcRadius") {
        Curve &arc = shape.curves[address.handle];
        arc = withRadius(arc, value);
    } else if (shape.kind == ShapeKind::Slot) {
        what == "width" ? void(shape.radius = 0.5 * value) : setSlotLength(shape, value);
    } else if (what == "rx" || what == "ry" || circle) {
        Vec2 &end = shape.nodes[what == "ry" ? 2 : 1];
        const Vec2 arm = end - shape.nodes[0];
        const Vec2 along =
            what == "ry" ? Vec2{0.0, 1.0} : Vec2{1.0, 0.0}; // in case another formula has made it a point
        end = shape.nodes[0] + (length(arm) > 0.0 ? (value / length(arm)) * arm : value * along);
    } else if (what == "radius") {
        shape.radius = value;
    } else {
        shape = changedBox(std::move(shape), what, value);
    }
    shape.cuts.clear();
    return {};
}

template <class Marker>
auto markerNumber(Marker &marker, const std::string &what) -> decltype(&marker.maxArea) {
    if (what == "size" || what == "growth") {
        return marker.size != 0.0 ? partNumber(marker, what) : nullptr; // without a size there is no growth either
    }
    return what == "x" ? &marker.at.x : what == "y" ? &marker.at.y : what == "area" ? &marker.maxArea : nullptr;
}

Status setMarkerNumber(MarkedRegion &marker, const std::string &what, double value) {
    if (what == "size" && !(value > 0.0)) { // 0 would mean that there is none
        return error("bad-number", "invalid size " + numberText(value, 6) + " of a region; expected a number above 0");
    }
    *markerNumber(marker, what) = value;
    return {};
}

Result<Document> checkedRegion(const Document &document, std::uint32_t index) {
    const MarkedRegion &marker = document.regionMarkers[index];
    if (marker.size != 0.0) {
        Result<Document> sized = setRegionSize(document, index, PartSize{marker.size, marker.growth});
        if (!sized) {
            return sized;
        }
    }
    return setRegionArea(document, index, marker.maxArea);
}

/// Returns a number of a boundary part, which has a size or a number of elements.
std::optional<double> boundaryNumber(const Document &document, const NumberAddress &address) {
    const std::string &what = address.quantity;
    const auto tag = static_cast<std::int32_t>(address.id);
    if (const auto counted = document.elementCounts.find(tag); counted != document.elementCounts.end()) {
        return what == "elements" ? std::optional<double>(counted->second.count)
               : what == "growth" ? std::optional(counted->second.growth)
                                  : std::nullopt;
    }
    const auto sized = document.spacing.partSizes.find(tag);
    return sized != document.spacing.partSizes.end() ? copied(partNumber(sized->second, what)) : std::nullopt;
}

Status setBoundaryNumber(Document &document, const NumberAddress &address, double value) {
    const auto tag = static_cast<std::int32_t>(address.id);
    const auto counted = document.elementCounts.find(tag);
    if (counted == document.elementCounts.end()) {
        *partNumber(document.spacing.partSizes.at(tag), address.quantity) = value;
        return {};
    }
    if (address.quantity == "growth") {
        counted->second.growth = value;
        return {};
    }
    const double count = std::round(value);
    if (!(count >= 1.0 && count <= kMaxElementCount) || std::fabs(value - count) > 1e-9 * count) {
        return error("bad-number", "invalid number of elements " + numberText(value, 6) +
                                       "; expected a whole number from 1 to " + std::to_string(kMaxElementCount));
    }
    counted->second.count = static_cast<std::uint32_t>(count);
    return {};
}

/// The tolerance of curves belongs to the document, not to its SpacingSpec.
constexpr std::string_view kCurveTolerance = "curveTolerance";

std::optional<double> SpacingSpec::*spacingNumber(const std::string &what) {
    using Place = std::optional<double> SpacingSpec::*;
    constexpr std::array<std::pair<std::string_view, Place>, 6> kNumbers{
        {{"size", &SpacingSpec::size},
         {"minimum", &SpacingSpec::minimum},
         {"maximum", &SpacingSpec::maximum},
         {"gradation", &SpacingSpec::gradation},
         {"segmentsPerTurn", &SpacingSpec::segmentsPerTurn},
         {"elementsAcross", &SpacingSpec::elementsAcross}}};
    for (const auto &[name, place] : kNumbers) {
        if (what == name) {
            return place;
        }
    }
    return nullptr;
}

/// Returns the index in `next` of the item at `index` in `before`. It is unchanged in lists of equal length, whose
/// items were only edited.
template <class T>
std::optional<std::uint32_t> movedIndex(const std::vector<T> &before, const std::vector<T> &next, std::uint32_t index) {
    if (before.size() == next.size()) {
        return index;
    }
    const auto found = index < before.size() ? std::find(next.begin(), next.end(), before[index]) : next.end();
    return found != next.end() ? std::optional(static_cast<std::uint32_t>(found - next.begin())) : std::nullopt;
}

/// Returns the maximum coordinate of the shape or box that a number belongs to, which limits its accuracy; 0 for
/// others.
double magnitudeAt(const Document &document, const NumberAddress &address) {
    const Shape *const shape = address.owner == Owner::Shape ? findShape(document, address.id) : nullptr;
    double largest = 0.0;
    if (address.owner == Owner::Source && (address.quantity == "width" || address.quantity == "height")) {
        const SizeSource &box = document.spacing.sources[address.id];
        largest = std::max({std::fabs(box.a.x), std::fabs(box.a.y), std::fabs(box.b.x), std::fabs(box.b.y)});
    }
    for (const Vec2 node : shape != nullptr ? shape->nodes : std::vector<Vec2>()) {
        largest = std::max({largest, std::fabs(node.x), std::fabs(node.y)});
    }
    return largest;
}

std::optional<std::uint32_t> movedHandle(const Document &before, const Document &next, const NumberAddress &address) {
    const Shape *const old = findShape(before, address.id), *const now = findShape(next, address.id);
    return old != nullptr && now != nullptr ? movedIndex(handlesOf(*old), handlesOf(*now), address.handle)
                                            : std::nullopt;
}

/// Returns the words for a quantity.
std::string quantityWords(const NumberAddress &address) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kWords{
        {{"x2", "second x"},
         {"y2", "second y"},
         {"endSize", "end size"},
         {"area", "maximum area"},
         {"elements", "number of elements"},
         {"segmentsPerTurn", "elements per turn"},
         {"elementsAcross", "elements across narrow places"},
         {kCurveTolerance, "curve tolerance"}}};
    const auto known =
        std::find_if(kWords.begin(), kWords.end(), [&](const auto &word) { return word.first == address.quantity; });
    return known != kWords.end() ? std::string(known->second) : address.quantity;
}

} // namespace

std::optional<NumberAddress> parseAddress(std::string_view text) {
    const std::vector<std::string_view> parts = pieces(text);
    NumberAddress address;
    if (parts.size() == 2 && parts[0] == "spacing") {
        address.quantity = parts[1];
        return address;
    }
    const auto owner = std::find_if(kOwners.begin(), kOwners.end(), [&](const auto &o) { return o.first == parts[0]; });
    if (owner == kOwners.end() || parts.size() < 3) {
        return std::nullopt;
    }
    address.owner = owner->second;
    address.quantity = parts[2];
    const std::optional<std::uint32_t> id = parseIndex(parts[1]);
    const std::optional<std::uint32_t> handle = parts.size() == 4 ? parseIndex(parts[3]) : std::nullopt;
    if (!id || parts.size() != (hasHandle(address) ? 4U : 3U) || (hasHandle(address) && !handle)) {
        return std::nullopt;
    }
    address.id = *id;
    address.handle = handle.value_or(0);
    return address;
}

std::optional<double> readNumber(const Document &document, const NumberAddress &address) {
    switch (address.owner) {
    case Owner::Shape: {
        const Shape *const shape = findShape(document, address.id);
        return shape != nullptr ? shapeNumber(*shape, address) : std::nullopt;
    }
    case Owner::Source:
        return address.id < document.spacing.sources.size()
                   ? sourceNumber(document.spacing.sources[address.id], address.quantity)
                   : std::nullopt;
    case Owner::Region:
        return address.id < document.regionMarkers.size()
                   ? copied(markerNumber(document.regionMarkers[address.id], address.quantity))
                   : std::nullopt;
    case Owner::Part:
        return boundaryNumber(document, address);
    case Owner::Spacing:
        break;
    }
    if (address.quantity == kCurveTolerance) {
        return document.curveTolerance > 0.0 ? std::optional(document.curveTolerance) : std::nullopt;
    }
    const auto place = spacingNumber(address.quantity);
    return place != nullptr ? document.spacing.*place : std::nullopt;
}

Status setNumber(Document &document, const NumberAddress &address, double value) {
    switch (address.owner) {
    case Owner::Shape: {
        std::shared_ptr<const Shape> &place = document.shapes[positionOf(document, address.id)];
        Shape shape = *place;
        Status status = setShapeNumber(shape, address, value);
        place = std::make_shared<const Shape>(std::move(shape));
        return status;
    }
    case Owner::Source:
        return setSourceNumber(document.spacing.sources[address.id], address.quantity, value);
    case Owner::Region:
        return setMarkerNumber(document.regionMarkers[address.id], address.quantity, value);
    case Owner::Part:
        return setBoundaryNumber(document, address, value);
    case Owner::Spacing:
        if (address.quantity == kCurveTolerance) {
            document.curveTolerance = value;
        } else {
            document.spacing.*spacingNumber(address.quantity) = value;
        }
    }
    return {};
}

Result<Document> checkedOwner(const Document &document, const NumberAddress &address) {
    switch (address.owner) {
    case Owner::Shape:
        return replaceShape(document, *findShape(document, address.id));
    case Owner::Source:
        return replaceSource(document, address.id, document.spacing.sources[address.id]);
    case Owner::Region:
        return checkedRegion(document, address.id);
    case Owner::Part: {
        const auto tag = static_cast<std::int32_t>(address.id);
        const auto counted = document.elementCounts.find(tag);
        return counted != document.elementCounts.end() ? setPartElements(document, tag, counted->second)
                                                       : setPartSize(document, tag, document.spacing.partSizes.at(tag));
    }
    case Owner::Spacing:
        break;
    }
    if (address.quantity == kCurveTolerance) {
        return setCurveTolerance(document, document.curveTolerance);
    }
    Diagnostics faults;
    checkSize(document.spacing.size, "spacing", faults);
    checkSegmentsPerTurn(document.spacing.segmentsPerTurn, faults);
    checkElementsAcross(document.spacing.elementsAcross, faults);
    checkLimits(document.spacing, faults);
    return faults.empty() ? Result<Document>(document) : faults;
}

std::optional<double> numberAt(const Document &document, std::string_view address) {
    const std::optional<NumberAddress> place = parseAddress(address);
    return place ? readNumber(document, *place) : std::nullopt;
}

std::string numberName(const Document &document, std::string_view text) {
    const std::optional<NumberAddress> address = parseAddress(text);
    if (!address || !readNumber(document, *address)) {
        return std::string(text);
    }
    const std::string what = quantityWords(*address) + " of ";
    switch (address->owner) {
    case Owner::Shape: {
        const Shape &shape = *findShape(document, address->id);
        if (address->quantity == "arcRadius") {
            return "radius of segment " + std::to_string(address->handle + 1) + " of " + displayName(shape);
        }
        const bool node = hasHandle(*address) && (isPath(shape) || shape.kind == ShapeKind::Rectangle);
        return what + (node ? nodeName(shape, address->handle) : displayName(shape));
    }
    case Owner::Source:
        return what + displayName(document.spacing.sources[address->id], address->id);
    case Owner::Region:
        return what + "region marker " + std::to_string(address->id + 1);
    case Owner::Part:
        return what + boundaryName(document.boundaryNames, static_cast<std::int32_t>(address->id));
    case Owner::Spacing:
        break;
    }
    return what + "the spacing";
}

bool hasValue(const Document &document, const NumberAddress &address, double value) {
    const std::optional<double> now = readNumber(document, address);
    constexpr double kRelative = 1e-9, kRounding = 1e-14; // differences of coordinates are as rounded as these
    return now && std::fabs(*now - value) <= kRelative * std::max(std::fabs(*now), std::fabs(value)) +
                                                 kRounding * magnitudeAt(document, address);
}

std::optional<std::string> movedAddress(const Document &before, const Document &next, const std::string &address) {
    std::optional<NumberAddress> place = parseAddress(address);
    if (!place) {
        return std::nullopt;
    }
    const bool node = place->owner == Owner::Shape && hasHandle(*place);
    const std::optional<std::uint32_t> index =
        place->owner == Owner::Source   ? movedIndex(before.spacing.sources, next.spacing.sources, place->id)
        : place->owner == Owner::Region ? movedIndex(before.regionMarkers, next.regionMarkers, place->id)
        : node                          ? movedHandle(before, next, *place)
                                        : std::optional(place->id);
    if (!index || place->owner == Owner::Spacing) {
        return index ? std::optional(address) : std::nullopt;
    }
    (node ? place->handle : place->id) = *index;
    return toString(*place);
}

std::string toString(const NumberAddress &address) {
    const auto owner =
        std::find_if(kOwners.begin(), kOwners.end(), [&](const auto &o) { return o.second == address.owner; });
    return owner == kOwners.end()
               ? "spacing/" + address.quantity
               : std::string(owner->first) + '/' + std::to_string(address.id) + '/' + address.quantity +
                     (hasHandle(address) ? '/' + std::to_string(address.handle) : "");
}

} // namespace forefront
