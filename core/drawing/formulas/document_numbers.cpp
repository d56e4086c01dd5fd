#include "core/drawing/formulas/document_numbers.hpp"

#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/formulas/element_counts.hpp"
#include "core/drawing/formulas/shape_numbers.hpp"
#include "core/drawing/formulas/source_numbers.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/spec/spec_check.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace forefront {
namespace {

using OwnerKind = NumberOwner::Kind;

std::optional<double> copied(const double *place) {
    return place != nullptr ? std::optional(*place) : std::nullopt;
}

template <class Part>
auto partNumber(Part &part, Quantity what) -> decltype(&part.size) {
    return what == Quantity::Size ? &part.size : what == Quantity::Growth ? &part.growth : nullptr;
}

template <class Marker>
auto markerNumber(Marker &marker, Quantity what) -> decltype(&marker.maxArea) {
    if (what == Quantity::Size || what == Quantity::Growth) {
        return marker.size != 0.0 ? partNumber(marker, what) : nullptr; // without a size there is no growth either
    }
    return what == Quantity::X      ? &marker.at.x
           : what == Quantity::Y    ? &marker.at.y
           : what == Quantity::Area ? &marker.maxArea
                                    : nullptr;
}

Status setMarkerNumber(MarkedRegion &marker, Quantity what, double value) {
    if (what == Quantity::Size && !(value > 0.0)) { // 0 would mean that there is none
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
    const Quantity what = address.quantity;
    const auto tag = static_cast<std::int32_t>(address.owner.id);
    if (const auto counted = document.elementCounts.find(tag); counted != document.elementCounts.end()) {
        return what == Quantity::Elements ? std::optional<double>(counted->second.count)
               : what == Quantity::Growth ? std::optional(counted->second.growth)
                                          : std::nullopt;
    }
    const auto sized = document.spacing.partSizes.find(tag);
    return sized != document.spacing.partSizes.end() ? copied(partNumber(sized->second, what)) : std::nullopt;
}

Status setBoundaryNumber(Document &document, const NumberAddress &address, double value) {
    const auto tag = static_cast<std::int32_t>(address.owner.id);
    const auto counted = document.elementCounts.find(tag);
    if (counted == document.elementCounts.end()) {
        *partNumber(document.spacing.partSizes.at(tag), address.quantity) = value;
        return {};
    }
    if (address.quantity == Quantity::Growth) {
        counted->second.growth = value;
        return {};
    }
    const Result<std::uint32_t> count = elementsFrom(value);
    if (!count) {
        return count.faults();
    }
    counted->second.count = *count;
    return {};
}

/// Returns the member of SpacingSpec that holds a number; null for others. The tolerance of curves belongs to the
/// document.
std::optional<double> SpacingSpec::*spacingNumber(Quantity what) {
    switch (what) {
    case Quantity::Size:
        return &SpacingSpec::size;
    case Quantity::Minimum:
        return &SpacingSpec::minimum;
    case Quantity::Maximum:
        return &SpacingSpec::maximum;
    case Quantity::Gradation:
        return &SpacingSpec::gradation;
    case Quantity::SegmentsPerTurn:
        return &SpacingSpec::segmentsPerTurn;
    case Quantity::ElementsAcross:
        return &SpacingSpec::elementsAcross;
    default:
        return nullptr;
    }
}

/// Returns the value of a dimension of the sketch; none for another constraint.
std::optional<double> dimensionValue(const Document &document, const NumberAddress &address) {
    const SketchConstraint *const constraint = findConstraint(document, address.owner.id);
    const bool has = constraint != nullptr && isDimension(constraint->kind) && address.quantity == Quantity::Value;
    return has ? std::optional(constraint->value) : std::nullopt;
}

void setDimensionValue(Document &document, std::uint32_t id, double value) {
    for (std::shared_ptr<const SketchConstraint> &place : document.constraints) {
        if (place->id == id) {
            SketchConstraint constraint = *place;
            constraint.value = value;
            place = std::make_shared<const SketchConstraint>(std::move(constraint));
        }
    }
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
    const Shape *const shape = address.owner.kind == OwnerKind::Shape ? findShape(document, address.owner.id) : nullptr;
    double largest = 0.0;
    if (address.owner.kind == OwnerKind::Source &&
        (address.quantity == Quantity::Width || address.quantity == Quantity::Height)) {
        const SizeSource &box = document.spacing.sources[address.owner.id];
        largest = std::max({std::fabs(box.a.x), std::fabs(box.a.y), std::fabs(box.b.x), std::fabs(box.b.y)});
    }
    for (const Vec2 node : shape != nullptr ? shape->nodes : std::vector<Vec2>()) {
        largest = std::max({largest, std::fabs(node.x), std::fabs(node.y)});
    }
    return largest;
}

std::optional<std::uint32_t> movedHandle(const Document &before, const Document &next, const NumberAddress &address) {
    const Shape *const old = findShape(before, address.owner.id), *const now = findShape(next, address.owner.id);
    return old != nullptr && now != nullptr ? movedIndex(handlesOf(*old), handlesOf(*now), address.handle)
                                            : std::nullopt;
}

std::string quantityWords(Quantity what) {
    switch (what) {
    case Quantity::X2:
        return "second x";
    case Quantity::Y2:
        return "second y";
    case Quantity::EndSize:
        return "end size";
    case Quantity::Area:
        return "maximum area";
    case Quantity::SegmentSize:
        return "size";
    case Quantity::SegmentGrowth:
        return "growth";
    case Quantity::SegmentElements:
    case Quantity::Elements:
        return "number of elements";
    case Quantity::SegmentsPerTurn:
        return "elements per turn";
    case Quantity::ElementsAcross:
        return "elements across narrow places";
    case Quantity::CurveTolerance:
        return "curve tolerance";
    default:
        return std::string(wordOf(what));
    }
}

} // namespace

std::optional<double> readNumber(const Document &document, const NumberAddress &address) {
    switch (address.owner.kind) {
    case OwnerKind::Shape: {
        const Shape *const shape = findShape(document, address.owner.id);
        return shape != nullptr ? shapeNumber(*shape, address) : std::nullopt;
    }
    case OwnerKind::Source:
        return address.owner.id < document.spacing.sources.size()
                   ? sourceNumber(document.spacing.sources[address.owner.id], address.quantity)
                   : std::nullopt;
    case OwnerKind::Region:
        return address.owner.id < document.regionMarkers.size()
                   ? copied(markerNumber(document.regionMarkers[address.owner.id], address.quantity))
                   : std::nullopt;
    case OwnerKind::Part:
        return boundaryNumber(document, address);
    case OwnerKind::Constraint:
        return dimensionValue(document, address);
    case OwnerKind::Spacing:
        break;
    }
    if (address.quantity == Quantity::CurveTolerance) {
        return document.curveTolerance > 0.0 ? std::optional(document.curveTolerance) : std::nullopt;
    }
    const auto place = spacingNumber(address.quantity);
    return place != nullptr ? document.spacing.*place : std::nullopt;
}

Status setNumber(Document &document, const NumberAddress &address, double value) {
    switch (address.owner.kind) {
    case OwnerKind::Shape: {
        std::shared_ptr<const Shape> &place = document.shapes[positionOf(document, address.owner.id)];
        Shape shape = *place;
        Status status = setShapeNumber(shape, address, value);
        place = std::make_shared<const Shape>(std::move(shape));
        return status;
    }
    case OwnerKind::Source:
        return setSourceNumber(document.spacing.sources[address.owner.id], address.quantity, value);
    case OwnerKind::Region:
        return setMarkerNumber(document.regionMarkers[address.owner.id], address.quantity, value);
    case OwnerKind::Part:
        return setBoundaryNumber(document, address, value);
    case OwnerKind::Constraint:
        setDimensionValue(document, address.owner.id, value);
        return {};
    case OwnerKind::Spacing:
        if (address.quantity == Quantity::CurveTolerance) {
            document.curveTolerance = value;
        } else if (const auto place = spacingNumber(address.quantity); place != nullptr) {
            document.spacing.*place = value;
        }
    }
    return {};
}

Result<Document> checkedOwner(const Document &document, const NumberAddress &address) {
    switch (address.owner.kind) {
    case OwnerKind::Shape:
        return replaceShape(document, *findShape(document, address.owner.id));
    case OwnerKind::Source:
        return replaceSource(document, address.owner.id, document.spacing.sources[address.owner.id]);
    case OwnerKind::Region:
        return checkedRegion(document, address.owner.id);
    case OwnerKind::Constraint: {
        const SketchConstraint &constraint = *findConstraint(document, address.owner.id);
        const std::string fault = constraintFault(document, constraint);
        return fault.empty() ? Result<Document>(document) : error("bad-constraint", constraint.name + ": " + fault);
    }
    case OwnerKind::Part: {
        const auto tag = static_cast<std::int32_t>(address.owner.id);
        const auto counted = document.elementCounts.find(tag);
        return counted != document.elementCounts.end() ? setPartElements(document, tag, counted->second)
                                                       : setPartSize(document, tag, document.spacing.partSizes.at(tag));
    }
    case OwnerKind::Spacing:
        break;
    }
    if (address.quantity == Quantity::CurveTolerance) {
        return setCurveTolerance(document, document.curveTolerance);
    }
    Diagnostics faults;
    checkSize(document.spacing.size, "spacing", faults);
    checkSegmentsPerTurn(document.spacing.segmentsPerTurn, faults);
    checkElementsAcross(document.spacing.elementsAcross, faults);
    checkLimits(document.spacing, faults);
    return faults.empty() ? Result<Document>(document) : faults;
}

int lengthPower(const Document &document, const NumberAddress &address) {
    switch (address.quantity) {
    case Quantity::Angle:
    case Quantity::Elements:
    case Quantity::ElementsAcross:
    case Quantity::Gradation:
    case Quantity::Growth:
    case Quantity::SegmentElements:
    case Quantity::SegmentGrowth:
    case Quantity::SegmentsPerTurn:
        return 0;
    case Quantity::Area:
        return 2;
    case Quantity::Value: {
        const SketchConstraint *const dimension = findConstraint(document, address.owner.id);
        return dimension != nullptr && dimension->kind != ConstraintKind::Angle ? 1 : 0;
    }
    case Quantity::ArcRadius:
    case Quantity::Bottom:
    case Quantity::CurveTolerance:
    case Quantity::EndSize:
    case Quantity::Height:
    case Quantity::Left:
    case Quantity::Length:
    case Quantity::Maximum:
    case Quantity::Minimum:
    case Quantity::Radius:
    case Quantity::Rx:
    case Quantity::Ry:
    case Quantity::SegmentSize:
    case Quantity::Size:
    case Quantity::Width:
    case Quantity::X:
    case Quantity::X2:
    case Quantity::Y:
    case Quantity::Y2:
        return 1;
    }
    return 0;
}

std::string numberName(const Document &document, const NumberAddress &address) {
    if (!readNumber(document, address)) {
        return toString(address);
    }
    const std::uint32_t id = address.owner.id;
    const std::string what = quantityWords(address.quantity) + " of ";
    switch (address.owner.kind) {
    case OwnerKind::Shape: {
        const Shape &shape = *findShape(document, id);
        if (address.quantity == Quantity::ArcRadius) {
            return "radius of segment " + std::to_string(address.handle + 1) + " of " + displayName(shape);
        }
        if (address.ofSegment()) {
            return what + segmentName(shape, address.handle);
        }
        const bool node = address.hasHandle() && (isPath(shape) || shape.is<RectangleForm>());
        return what + (node ? nodeName(shape, address.handle) : displayName(shape));
    }
    case OwnerKind::Source:
        return what + displayName(document.spacing.sources[id], id);
    case OwnerKind::Region:
        return what + "region marker " + std::to_string(id + 1);
    case OwnerKind::Constraint:
        return what + findConstraint(document, id)->name;
    case OwnerKind::Part:
        return what + boundaryName(document.boundaryNames, static_cast<std::int32_t>(id));
    case OwnerKind::Spacing:
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

std::optional<NumberAddress> movedAddress(const Document &before, const Document &next, const NumberAddress &address) {
    const NumberOwner owner = address.owner;
    const bool node = address.hasHandle();
    const std::optional<std::uint32_t> index =
        owner.kind == OwnerKind::Source   ? movedIndex(before.spacing.sources, next.spacing.sources, owner.id)
        : owner.kind == OwnerKind::Region ? movedIndex(before.regionMarkers, next.regionMarkers, owner.id)
        : node                            ? movedHandle(before, next, address)
                                          : std::optional(owner.id);
    if (!index) {
        return std::nullopt;
    }
    NumberAddress moved = address;
    (node ? moved.handle : moved.owner.id) = *index;
    return moved;
}

} // namespace forefront
