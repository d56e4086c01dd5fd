#pragma once

#include "core/drawing/document/background_picture.hpp"
#include "core/drawing/document/number_address.hpp"
#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// The kind of a shape, which determines the meaning of its nodes.
enum class ShapeKind : std::uint8_t {
    Polygon,   ///< closed path, nodes in order
    Polyline,  ///< open path
    Rectangle, ///< two opposite corners
    Circle,    ///< centre, point on the circle
    Point,     ///< one node
    Ellipse,   ///< centre, ends of two conjugate semi-axes; drawn from the first towards the second
    Slot       ///< centres of two half circles of the same radius, joined by straight sides
};

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

/// A drawn shape. Immutable once in a Document; edits replace it.
struct Shape {
    std::uint32_t id = 0; ///< unique in the document, never reused
    ShapeKind kind = ShapeKind::Polygon;
    ShapeUse use = ShapeUse::Boundary;
    std::vector<Vec2> nodes;
    std::int32_t tag = 1;                  ///< of its segments, >= 1
    std::vector<std::int32_t> segmentTags; ///< per segment where they differ; empty: all `tag`
    std::string name;                      ///< shown in lists; names of tags are in Document::boundaryNames
    /// For a polygon or polyline, the curve of each segment from node to node; a line marks a straight segment. A cubic
    /// begins and ends exactly at its nodes, an arc up to rounding. Empty: all segments are straight.
    std::vector<Curve> curves;
    /// For each segment of the outline, the parameters between 0 and 1 at which its curve is divided into chords in the
    /// domain; 1 alone: it is a single chord. Readers keep the chords of the domain that they read, since these are
    /// known not to cross anything. Empty: computed from the tolerance.
    std::vector<std::vector<double>> cuts;
    double radius = 0.0; ///< of a rectangle's corners, where at most half its shorter side counts; of a slot's ends
    bool hidden = false; ///< neither drawn nor picked, but part of the domain
    bool locked = false; ///< drawn, but neither picked nor moved
    /// Element sizes at nodes, by handle (see handlesOf()); not at the centre of a circle or an ellipse, nor at a slot.
    std::map<std::uint32_t, PartSize> nodeSizes;

    friend bool operator==(const Shape &, const Shape &) = default;
};

/// The number of elements along each segment of a boundary part. Where the segments differ in length, the longest gets
/// the number, and the others get elements of the same size, which becomes the size of the part: see spacingOf().
struct PartElements {
    std::uint32_t count = 1;           ///< >= 1
    double growth = PartSize{}.growth; ///< >= 0, see PartSize

    friend bool operator==(const PartElements &, const PartElements &) = default;
};

/// A named number of a document, such as r = 0.4 or gap = 2*r.
struct Parameter {
    std::string name;       ///< a letter or _, then letters, digits and _
    std::string expression; ///< of numbers, functions and other parameters

    friend bool operator==(const Parameter &, const Parameter &) = default;
};

/// Everything that a user edits and saves: the drawing, spacing and options. Shapes are shared, so copies are cheap
/// enough for unlimited undo.
struct Document {
    std::vector<std::shared_ptr<const Shape>> shapes;
    std::vector<RegionMarker> regionMarkers;
    std::map<std::int32_t, std::string> boundaryNames;
    std::map<std::int32_t, std::string> regionNames;
    SpacingSpec spacing; ///< without the sizes that follow from `elementCounts`: see spacingOf()
    /// Numbers of elements of boundary parts, by tag, in place of sizes in `spacing`.
    std::map<std::int32_t, PartElements> elementCounts;
    MeshingOptions options;
    MeshLimits limits; ///< that its meshes must meet
    /// Maximum distance between a curve and its chords in the domain, relative to the radius of a circle or the size of
    /// another curve. The mesh follows the curve itself.
    double circleTolerance = 0.002;
    double curveTolerance = 0.0; ///< see Domain::curveTolerance
    std::uint32_t nextId = 1;
    std::vector<Parameter> parameters;
    std::map<NumberAddress, std::string> formulas; ///< of numbers of the document
    std::optional<BackgroundPicture> picture;      ///< below the drawing
};

} // namespace forefront
