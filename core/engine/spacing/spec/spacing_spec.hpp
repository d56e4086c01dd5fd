#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/base/vec2.hpp"
#include "core/engine/spacing/spec/placed_sizes.hpp"
#include "core/engine/spacing/spec/raster.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace FOREFRONT_API forefront {

/// Shape of a size source.
enum class SourceShape : std::uint8_t { Point, Line, Circle, Box };

template <>
struct EnumWords<SourceShape> {
    static constexpr auto kLast = SourceShape::Box;
    static constexpr std::array<std::string_view, 4> kList = {"point", "line", "circle", "box"};
};

/// A size source: the spacing is size + growth·d at distance d from the shape.
struct SizeSource {
    SourceShape shape = SourceShape::Point;
    Vec2 a; ///< point; first end; centre; corner of a box
    Vec2 b; ///< second end (Line); opposite corner (Box)
    /// The spacing is `size` within this distance; required for Circle, optional for the others.
    double radius = 0.0;
    double size = 1.0;   ///< > 0
    double growth = 0.2; ///< >= 0, change of spacing per unit of distance
    std::string name;
    /// Size at b (Line only), > 0. Along the line, the size changes linearly from `size` at a; beside it, the nearest
    /// point of the line counts. Absent: `size` along the whole line.
    std::optional<double> endSize{};
    double angle{}; ///< of the sides of a box to the axes, in degrees, counter-clockwise (Box only)
    /// True: a gradient over the whole plane (Line only). The size depends on the position along the line alone: it
    /// changes between the ends and is constant beyond them. There is no growth.
    bool plane{};
    bool geometric{}; ///< a gradient changes by equal factors, not by equal steps

    friend bool operator==(const SizeSource &, const SizeSource &) = default;
};

/// Painted spacing: square tiles of `kTileNodes`² values at the nodes of a square grid. The lower left node of tile (i,
/// j) is at origin + pitch·kTileSpan·(i, j); a value of 0 means unpainted. Between nodes the spacing is bilinear where
/// all four nodes are painted, else the minimum painted value of the four.
struct PaintedSpacing {
    static constexpr int kTileSpan = 16;
    static constexpr int kTileNodes = kTileSpan; ///< nodes (0..15)²; the upper edges belong to the next tiles
    using Tile = std::array<float, kTileNodes * kTileNodes>;

    Vec2 origin;
    double pitch = 1.0; ///< distance between nodes
    /// True: where it is painted, the paint replaces the sizes of other rules, larger or smaller, except those of the
    /// boundary and of regions; see SpacingSpec. False, as in projects of older versions: it only refines.
    bool replaces = false;
    std::map<std::pair<std::int32_t, std::int32_t>, std::shared_ptr<const Tile>> tiles;
};

/// Maximum |∇ρ| of painted, boundary, region and automatic parts where none is given.
inline constexpr double kDefaultGradation = 0.25;

/// Maximum |∇ρ| of expressions and background meshes where none is given. Elements cannot follow a spacing that changes
/// faster: at this one, the areas of neighbours already differ by a factor of more than two.
inline constexpr double kSteepestGradation = 0.5;

/// Nodal spacing on a triangle mesh; undefined outside the mesh.
struct BackgroundMesh {
    std::vector<Vec2> nodes;
    std::vector<std::array<std::uint32_t, 3>> elements;
    std::vector<double> values; ///< one per node, > 0

    friend bool operator==(const BackgroundMesh &, const BackgroundMesh &) = default;
};

/// The node spacing function ρ(x, y) as data, part of the document: every element size that there is, as rules and as
/// sizes of places of the domain.
///
/// The given parts are combined by minimum, clamped to [minimum, maximum], then limited so that |∇ρ| <= gradation.
/// Paint that replaces other rules stands in place of all of them but sizes of boundary parts, nodes and regions,
/// lengths of boundary segments and region areas. Where nothing covers the whole domain (no size, expression, function,
/// gradient, source or boundary lengths), automatic spacing applies: from boundary lengths, bends, narrow places and
/// domain size, graded. It is combined by minimum with paint, sizes of parts and regions, region areas and, with
/// `keepAutomatic`, sources, and fills in outside a background mesh. In regions with a size or a maximum area, that
/// stands in place of the domain size, so that they may be coarser.
struct SpacingSpec {
    std::optional<double> size;                       ///< constant spacing, > 0
    std::optional<std::string> expression;            ///< formula in x and y, for example "max(0.1, 0.2*sqrt(x*x+y*y))"
    std::map<std::string, double, std::less<>> names; ///< other names that the expression may use, such as parameters
    /// Rasters that the expression may call by name, none null, such as depth(x, y); see compileSpacingExpression().
    RasterMap rasters;
    /// The size as a function of the position, > 0 in the domain; called with finite coordinates in and near the
    /// domain's box. The same position must give the same value. An exception that it throws reaches the caller of the
    /// function that meshes, see MeshingJob. A project file cannot hold it.
    std::function<double(Vec2)> function;
    /// The same for many positions at once: fills in the size at each. Give this or `function`.
    std::function<void(std::span<const Vec2> positions, std::span<double> sizes)> bulkFunction;
    /// True: the function may be called from several threads at once. False: only the thread that meshes calls it,
    /// which then does all work, and MeshingOptions::threads has no effect. The mesh is the same.
    bool functionThreadSafe = false;
    std::vector<SizeSource> sources;
    /// True: sources only refine automatic spacing. False: they replace it. Absent: nobody has chosen; they replace it.
    std::optional<bool> keepAutomatic;
    PaintedSpacing paint;
    std::shared_ptr<const BackgroundMesh> background;
    /// Sizes of boundary parts and constraints by tag; they also apply to points with the tag.
    std::map<std::int32_t, PartSize> partSizes;
    PlacedSizes placed;        ///< sizes of nodes, regions and segments, numbers of elements along lines and curves
    bool fromBoundary = false; ///< the given lengths of boundary segments act as sources
    /// Edges per full turn of curved boundaries, >= 0; 0: curvature is ignored. Absent: 40 where the spacing is
    /// automatic, 0 elsewhere.
    std::optional<double> segmentsPerTurn;
    /// Elements across narrow places, >= 0; 0: narrow places are ignored. Absent: 2 where the spacing is automatic,
    /// within a limit on their total number; 0 elsewhere. Corners are not narrow places, except tips of less than 20
    /// degrees, which are followed down to a width of 1/8 of the spacing.
    std::optional<double> elementsAcross;
    std::optional<double> minimum; ///< > 0
    std::optional<double> maximum; ///< > 0
    /// Maximum |∇ρ|, > 0; absent: 0.25 for painted, boundary, region and automatic parts (0.18 for the automatic part
    /// of domains with curves, which leaves better shapes beside bends), kSteepestGradation for expressions, functions
    /// and background meshes, with a note where they are steeper, and no limit for parts with a growth of their own.
    /// The limited spacing is within 1 % of exact for sources (see GradedSources for the exception) and boundary
    /// lengths, within 2 % for paint, expression, function and mesh.
    std::optional<double> gradation;

    /// Replaces the rules by others, as options of the command line do: everything but the sizes of nodes and regions,
    /// which belong to the domain and stay. Sizes and numbers of elements along segments belong to the rules that they
    /// were chosen with and go.
    /// `rules`: its own placed sizes, which belong to another domain, are dropped.
    void replaceRules(SpacingSpec rules) {
        rules.placed = std::exchange(placed, {});
        rules.placed.elements.clear();
        rules.placed.biases.clear();
        rules.placed.segments.clear();
        *this = std::move(rules);
    }

    /// Returns true if no part is given, so that the spacing is automatic.
    bool automatic() const { return usesAutomatic() && sources.empty() && paint.tiles.empty() && !background; }
    /// Returns true if no part covers the whole domain, so that automatic spacing applies together with the others.
    bool usesAutomatic() const {
        return !size && !expression && !hasFunction() && !fromBoundary && !hasGradient() &&
               (sources.empty() || keepAutomatic.value_or(false));
    }
    /// Returns true if the size is a function of the caller.
    bool hasFunction() const { return function || bulkFunction; }
    /// Returns true if a source is a gradient over the whole plane.
    bool hasGradient() const {
        return std::any_of(sources.begin(), sources.end(), [](const SizeSource &source) { return source.plane; });
    }
};

} // namespace forefront
