#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/geometry/curve.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace FOREFRONT_API forefront {

/// The word for the form of a shape, in files and messages.
enum class ShapeKind : std::uint8_t { Polygon, Polyline, Rectangle, Circle, Point, Ellipse, Slot };

template <>
struct EnumWords<ShapeKind> {
    static constexpr auto kLast = ShapeKind::Slot;
    static constexpr std::array<std::string_view, 7> kList = {"polygon", "polyline", "rectangle", "circle",
                                                              "point",   "ellipse",  "slot"};
};

/// The role of a shape in the domain.
enum class ShapeUse : std::uint8_t {
    Boundary,  ///< even-odd: an outermost shape is an outline, one inside it a hole, one inside a hole an island
    Constraint ///< its segments (or point) must be in the mesh; a closed one bounds a separate region
};

template <>
struct EnumWords<ShapeUse> {
    static constexpr auto kLast = ShapeUse::Constraint;
    static constexpr std::array<std::string_view, 2> kList = {"boundary", "constraint"};
};

// The form of a shape says what its nodes mean, and holds what only this form has. The nodes themselves are in
// Shape::nodes for all forms: dragging, snapping, mapping and formulas treat them as one list of free points.

/// A path: segments join the nodes in order. A polygon is closed by one more segment, from the last node to the first;
/// a polyline is open.
struct PathForm {
    bool closed = true;
    /// The curve of each segment; a line marks a straight one. A cubic begins and ends exactly at its nodes, an arc up
    /// to rounding. Empty: all segments are straight.
    std::vector<Curve> curves{};

    friend bool operator==(const PathForm &, const PathForm &) = default;
};

/// A rectangle; its nodes are two opposite corners.
struct RectangleForm {
    double radius = 0.0; ///< of its corners; at most half the shorter side counts

    friend bool operator==(const RectangleForm &, const RectangleForm &) = default;
};

/// A circle; its nodes are the centre and a point on it.
struct CircleForm {
    friend bool operator==(const CircleForm &, const CircleForm &) = default;
};

/// A point, of one node.
struct PointForm {
    friend bool operator==(const PointForm &, const PointForm &) = default;
};

/// An ellipse; its nodes are the centre and the ends of two conjugate semi-axes. It runs from the first end towards the
/// second.
struct EllipseForm {
    friend bool operator==(const EllipseForm &, const EllipseForm &) = default;
};

/// A slot: two half circles joined by straight sides; its nodes are the centres of the half circles.
struct SlotForm {
    double radius = 0.0; ///< of its ends, half its width

    friend bool operator==(const SlotForm &, const SlotForm &) = default;
};

using ShapeForm = std::variant<PathForm, RectangleForm, CircleForm, PointForm, EllipseForm, SlotForm>;

/// Joins functions, one for each form, into a visitor of forms. Without a function for a form it does not compile.
template <class... Functions>
struct FormVisitor : Functions... {
    using Functions::operator()...;
};

/// The size of the elements along one segment of a shape: a length, or a number of elements from which it follows.
struct SegmentSize {
    double size = 0.0;                 ///< > 0; ignored where a number of elements is given
    std::uint32_t elements = 0;        ///< along the whole segment; 0: `size` is given
    double growth = PartSize{}.growth; ///< >= 0, see PartSize
    ElementBias bias{};                ///< of a number of elements, in the direction of the outline

    friend bool operator==(const SegmentSize &, const SegmentSize &) = default;
};

/// A drawn shape. Immutable once in a Document; edits replace it.
struct Shape {
    std::uint32_t id = 0; ///< unique in the document, never reused
    ShapeUse use = ShapeUse::Boundary;
    ShapeForm form;
    std::vector<Vec2> nodes;               ///< their meaning depends on the form
    std::int32_t tag = 1;                  ///< of its segments, >= 1
    std::vector<std::int32_t> segmentTags; ///< per segment where they differ; empty: all `tag`
    std::string name;                      ///< shown in lists; names of tags are in Document::boundaryNames
    /// For each segment of the outline, the parameters between 0 and 1 at which its curve is divided into chords in the
    /// domain; 1 alone: it is a single chord. Readers keep the chords of the domain that they read, since these are
    /// known not to cross anything. Empty: computed from the tolerance.
    std::vector<std::vector<double>> cuts;
    bool hidden = false;       ///< neither drawn nor picked, but part of the domain
    bool locked = false;       ///< drawn, but neither picked nor moved
    std::uint32_t group = 0;   ///< shapes with the same number are selected as one; 0: in none
    bool construction = false; ///< drawn and constrained, but not part of the domain
    /// Element sizes at nodes, by handle (see handlesOf()); not at the centre of a circle or an ellipse, nor at a slot.
    std::map<std::uint32_t, PartSize> nodeSizes;
    /// Element sizes along segments, by tagged part (see taggedSegments()), in place of those of their boundary parts.
    std::map<std::uint32_t, SegmentSize> segmentSizes;

    template <class Form>
    bool is() const {
        return std::holds_alternative<Form>(form);
    }
    bool isPolygon() const { return is<PathForm>() && path().closed; }
    bool isPolyline() const { return is<PathForm>() && !path().closed; }

    /// Returns the form, which the shape must have.
    template <class Form>
    Form &as() {
        return std::get<Form>(form);
    }
    template <class Form>
    const Form &as() const {
        return std::get<Form>(form);
    }
    PathForm &path() { return as<PathForm>(); }
    const PathForm &path() const { return as<PathForm>(); }

    /// Calls the function for the form of the shape. There must be one for each form.
    template <class... Functions>
    decltype(auto) visit(Functions &&...functions) const {
        return std::visit(FormVisitor<std::remove_cvref_t<Functions>...>{std::forward<Functions>(functions)...}, form);
    }
    template <class... Functions>
    decltype(auto) visit(Functions &&...functions) {
        return std::visit(FormVisitor<std::remove_cvref_t<Functions>...>{std::forward<Functions>(functions)...}, form);
    }

    ShapeKind kind() const {
        return visit(
            [](const PathForm &path) { return path.closed ? ShapeKind::Polygon : ShapeKind::Polyline; },
            [](const RectangleForm &) { return ShapeKind::Rectangle; },
            [](const CircleForm &) { return ShapeKind::Circle; }, [](const PointForm &) { return ShapeKind::Point; },
            [](const EllipseForm &) { return ShapeKind::Ellipse; }, [](const SlotForm &) { return ShapeKind::Slot; });
    }

    friend bool operator==(const Shape &, const Shape &) = default;
};

/// Returns the form of a kind, without curves or a radius.
ShapeForm formOf(ShapeKind kind);

} // namespace forefront
