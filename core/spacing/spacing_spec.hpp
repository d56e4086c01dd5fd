#pragma once

#include "core/base/vec2.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

enum class SourceShape : std::uint8_t { Point, Line, Circle };

/// A size source: spacing `size` on the shape, growing with the distance d to it as size + growth·d.
struct SizeSource {
    SourceShape shape = SourceShape::Point;
    Vec2 a;              ///< point; first end; centre
    Vec2 b;              ///< second end (Line only)
    double radius = 0.0; ///< Circle only: within the disc, spacing is `size`; point and line may have a radius too
    double size = 1.0;   ///< > 0
    double growth = 0.2; ///< >= 0, change of spacing per unit of distance
    std::string name;
};

/// Painted spacing: square tiles of `kTileNodes`² nodal values on a lattice of pitch `pitch`, lower left node of tile
/// (i, j) at origin + pitch·kTileSpan·(i, j). A value of 0 means unpainted. Between nodes the spacing is bilinear where
/// all four nodes are painted, else the least painted value of the four.
struct PaintedSpacing {
    static constexpr int kTileSpan = 16;
    static constexpr int kTileNodes = kTileSpan; ///< nodes (0..15)²; the upper edges belong to the next tiles
    using Tile = std::array<float, kTileNodes * kTileNodes>;

    Vec2 origin;
    double pitch = 1.0;
    std::map<std::pair<std::int32_t, std::int32_t>, std::shared_ptr<const Tile>> tiles;
};

/// Nodal spacing on a triangle mesh; outside of it the source says nothing.
struct BackgroundMesh {
    std::vector<Vec2> nodes;
    std::vector<std::array<std::uint32_t, 3>> elements;
    std::vector<double> values; ///< one per node, > 0
};

/// The node spacing function ρ(x, y) as data, part of the document. All given parts are combined by minimum, then
/// clamped to [minimum, maximum], then limited so that |∇ρ| <= gradation. With nothing given (no size, expression,
/// source, paint, mesh), `automatic` spacing applies: from boundary lengths, narrow places and domain size, graded. It
/// also fills in where paint or a background mesh is all that is given: by minimum with paint, and outside of the mesh.
struct SpacingSpec {
    std::optional<double> size;            ///< constant, > 0
    std::optional<std::string> expression; ///< in x and y, muparser syntax, for example "max(0.1, 0.2*sqrt(x*x+y*y))"
    std::vector<SizeSource> sources;
    PaintedSpacing paint;
    std::shared_ptr<const BackgroundMesh> background;
    bool fromBoundary = false;     ///< boundary segment lengths as given are sources too
    std::optional<double> minimum; ///< > 0
    std::optional<double> maximum; ///< > 0
    /// > 0; absent: 0.25 for painted, boundary and automatic parts, no limit for the others. The limited spacing is
    /// exact for sources and boundary lengths but for 1 % of interpolation, and within 2 % for paint, expression and
    /// mesh.
    std::optional<double> gradation;

    bool automatic() const {
        return !size && !expression && sources.empty() && paint.tiles.empty() && !background && !fromBoundary;
    }
};

} // namespace forefront
