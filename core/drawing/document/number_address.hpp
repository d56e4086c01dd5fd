#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace FOREFRONT_API forefront {

/// A kind of number of a document; its word is the one in project files. The words are in alphabetical order, so that
/// formulas are applied in the order of their texts.
enum class Quantity : std::uint8_t {
    Angle,
    ArcRadius,
    Area,
    Bottom,
    CurveTolerance,
    Elements,
    ElementsAcross,
    EndSize,
    Gradation,
    Growth,
    Height,
    Left,
    Length,
    Maximum,
    Minimum,
    Radius,
    Rx,
    Ry,
    SegmentElements,
    SegmentGrowth,
    SegmentSize,
    SegmentsPerTurn,
    Size,
    Value,
    Width,
    X,
    X2,
    Y,
    Y2
};

template <>
struct EnumWords<Quantity> {
    static constexpr auto kLast = Quantity::Y2;
    static constexpr std::array<std::string_view, 29> kList = {"angle",
                                                               "arcRadius",
                                                               "area",
                                                               "bottom",
                                                               "curveTolerance",
                                                               "elements",
                                                               "elementsAcross",
                                                               "endSize",
                                                               "gradation",
                                                               "growth",
                                                               "height",
                                                               "left",
                                                               "length",
                                                               "maximum",
                                                               "minimum",
                                                               "radius",
                                                               "rx",
                                                               "ry",
                                                               "segmentElements",
                                                               "segmentGrowth",
                                                               "segmentSize",
                                                               "segmentsPerTurn",
                                                               "size",
                                                               "value",
                                                               "width",
                                                               "x",
                                                               "x2",
                                                               "y",
                                                               "y2"};
};

/// The item of a document that a number belongs to.
struct NumberOwner {
    enum class Kind : std::uint8_t { Constraint, Part, Region, Shape, Source, Spacing };
    Kind kind = Kind::Spacing;
    std::uint32_t id = 0; ///< of the shape or sketch constraint; index of the source or marker; tag of the part

    static constexpr NumberOwner ofConstraint(std::uint32_t id) { return {Kind::Constraint, id}; }
    static constexpr NumberOwner ofPart(std::int32_t tag) { return {Kind::Part, static_cast<std::uint32_t>(tag)}; }
    static constexpr NumberOwner ofRegion(std::uint32_t index) { return {Kind::Region, index}; }
    static constexpr NumberOwner ofShape(std::uint32_t id) { return {Kind::Shape, id}; }
    static constexpr NumberOwner ofSource(std::uint32_t index) { return {Kind::Source, index}; }
    static constexpr NumberOwner ofSpacing() { return {}; }

    friend constexpr auto operator<=>(const NumberOwner &, const NumberOwner &) = default;
};

template <>
struct EnumWords<NumberOwner::Kind> {
    static constexpr auto kLast = NumberOwner::Kind::Spacing;
    static constexpr std::array<std::string_view, 6> kList = {"constraint", "part",   "region",
                                                              "shape",      "source", "spacing"};
};

/// The address of a number of a document.
///
/// In project files: "shape/ID/x/K" and "shape/ID/y/K" for handle K (see handlesOf()), "shape/ID/radius" for a circle
/// or rounded corners, "shape/ID/size/K" and "shape/ID/growth/K" for the size at a node, "shape/ID/arcRadius/K" for
/// segment K of a path, an arc of a circle, "shape/ID/segmentSize/K", "segmentElements/K" and "segmentGrowth/K" for the
/// size along segment K, "shape/ID/rx" and "ry" for an ellipse, "shape/ID/left", "bottom", "width",
/// "height" for a rectangle, "shape/ID/width" and "length" for a slot (the distance between its centres); "source/K/x",
/// "y", "x2", "y2", "angle", "radius", "size", "endSize", "growth" for a size source, "width" and "height" for a box,
/// along its angle and across it; "region/K/x", "y", "area", "size", "growth" for a region marker; "part/TAG/size",
/// "elements", "growth" for a boundary part; "spacing/size", "minimum", "maximum", "gradation", "segmentsPerTurn",
/// "elementsAcross", "curveTolerance"; "constraint/ID/value" for a dimension of the sketch. ID is the number of the
/// shape or constraint; indices count from 0.
struct NumberAddress {
    NumberOwner owner;
    Quantity quantity = Quantity::Size;
    std::uint32_t handle = 0; ///< of a number at a handle or segment, see hasHandle()

    /// Returns true if a shape has such a number for each of several handles or segments.
    constexpr bool hasHandle() const {
        return owner.kind == NumberOwner::Kind::Shape &&
               (quantity == Quantity::X || quantity == Quantity::Y || quantity == Quantity::Size ||
                quantity == Quantity::Growth || quantity == Quantity::ArcRadius || ofSegment());
    }

    /// Returns true for a number of SegmentSize.
    constexpr bool ofSegment() const {
        return quantity == Quantity::SegmentSize || quantity == Quantity::SegmentGrowth ||
               quantity == Quantity::SegmentElements;
    }

    friend constexpr auto operator<=>(const NumberAddress &, const NumberAddress &) = default;
};

/// Returns the address that a text of a project file stands for; none for an invalid text.
std::optional<NumberAddress> parseAddress(std::string_view text);
/// Returns the text of an address in project files.
std::string toString(const NumberAddress &address);

} // namespace forefront
