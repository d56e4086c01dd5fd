#pragma once

#include "core/drawing/document/background_picture.hpp"
#include "core/drawing/document/number_address.hpp"
#include "core/drawing/document/shape.hpp"
#include "core/drawing/document/sketch_constraint.hpp"
#include "core/engine/base/api.hpp"
#include "core/engine/base/length_unit.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/mapped_spec.hpp"
#include "core/engine/domain/periodic.hpp"
#include "core/engine/layers/layer_spec.hpp"
#include "core/engine/mesh/limits.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/engine/strips/strip_spec.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace FOREFRONT_API forefront {

/// A region marked in a drawing, with the sizes of its elements, which move with it; see RegionMarker and RegionSize.
struct MarkedRegion {
    Vec2 at;              ///< any point inside the face
    std::int32_t tag = 1; ///< >= 1
    double maxArea = 0.0; ///< 0: no limit
    double size{};        ///< 0: none is given
    double growth{0.2};   ///< >= 0

    RegionSize sizes() const { return {at, maxArea, size, growth}; }

    friend bool operator==(const MarkedRegion &, const MarkedRegion &) = default;
};

/// The number of elements along each segment of a boundary part. Where the segments differ in length, the longest gets
/// the number, and the others get elements of the same size, which becomes the size of the part: see spacingOf().
struct PartElements {
    std::uint32_t count = 1;           ///< >= 1
    double growth = PartSize{}.growth; ///< >= 0, see PartSize

    friend bool operator==(const PartElements &, const PartElements &) = default;
};

/// A line across the whole plane that nodes snap to; never part of the domain.
struct Guide {
    bool upright = false; ///< x = at, else y = at
    double at = 0.0;

    friend bool operator==(const Guide &, const Guide &) = default;
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
    std::vector<MarkedRegion> regionMarkers;
    std::map<std::int32_t, std::string> boundaryNames;
    std::map<std::int32_t, std::string> regionNames;
    /// The rules, without placed sizes; nodes, regions and `elementCounts` give those: see spacingOf().
    SpacingSpec spacing;
    /// Numbers of elements of boundary parts, by tag, in place of sizes in `spacing`.
    std::map<std::int32_t, PartElements> elementCounts;
    std::vector<LayerSpec> layers;              ///< boundary layers, at most one specification for each tag
    std::vector<PeriodicSpec> periodic;         ///< tags that are divided alike, each in one pair at most
    std::vector<std::int32_t> cracks;           ///< tags of inner lines that are cracks, each once
    std::vector<MappedSpec> mapped;             ///< regions that are filled by rows, each once
    std::vector<std::int32_t> openBoundaries;   ///< tags of parts through which water flows, each once
    std::string elevation;                      ///< of the nodes, an expression: see elevationsOf(); empty: none
    std::vector<StripSpec> strips;              ///< inner lines with a width, at most one specification for each tag
    std::vector<RegionElements> regionElements; ///< regions with other elements than `options` asks for, each once
    MeshingOptions options;
    MeshLimits limits; ///< that its meshes must meet
    /// Maximum distance between a curve and its chords in the domain, relative to the radius of a circle or the size of
    /// another curve. The mesh follows the curve itself.
    double circleTolerance = 0.002;
    double curveTolerance = 0.0; ///< see Domain::curveTolerance
    std::uint32_t nextId = 1;    ///< of shapes and sketch constraints
    /// Relations and dimensions that the shapes satisfy, in the order of their ids.
    std::vector<std::shared_ptr<const SketchConstraint>> constraints;
    std::vector<Parameter> parameters;
    std::map<NumberAddress, std::string> formulas; ///< of numbers of the document
    std::optional<BackgroundPicture> picture;      ///< below the drawing
    std::vector<Guide> guides;
    LengthUnit unit = LengthUnit::None; ///< of its coordinates and sizes
};

} // namespace forefront
