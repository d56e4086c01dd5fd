#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/mesh/half_edges.hpp"
#include "core/engine/mesh/mesh_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

class SpacingField;

/// The kind of part that a measure has a value for.
enum class MeshPart : std::uint8_t { Elements, Edges, Nodes };

template <>
struct EnumWords<MeshPart> {
    static constexpr auto kLast = MeshPart::Nodes;
    static constexpr std::array<std::string_view, 3> kList = {"element", "edge", "node"};
};

/// A quantity that describes the quality of a mesh. infoOf() describes each one.
enum class Measure : std::uint8_t {
    ShapeFactor,
    ScaledJacobian,
    MinAngle,
    MaxAngle,
    Aspect,
    Area,
    AreaRatio,
    Length,
    SizeRatio,
    Conformity,
    Across,
    IslandArea,
    Valence,
    Region,
    Birth
};

template <>
struct EnumWords<Measure> {
    static constexpr auto kLast = Measure::Birth;
    static constexpr std::array<std::string_view, 15> kList = {
        "alpha", "scaled-jacobian", "min-angle", "max-angle",   "aspect",  "area",   "area-ratio", "length",
        "size",  "delta",           "across",    "island-area", "valence", "region", "birth"};
};

/// The end of a measure's range at which values are bad.
enum class BadEnd : std::uint8_t {
    Low,
    High,
    FarFromOne, ///< on a logarithmic scale: 0.5 is as bad as 2
    None        ///< no value is better than another
};

/// The description of a measure.
struct MeasureInfo {
    const char *name;    ///< "Minimum angle"
    const char *symbol;  ///< short, for legends and tables: "min ∠"
    const char *unit;    ///< "°", or empty
    MeshPart part;       ///< the kind of part that is measured
    BadEnd bad;          ///< its bad values
    bool logarithmic;    ///< shown on a logarithmic scale
    double minimum;      ///< of the values it can have
    double maximum;      ///< of the values it can have; infinity: unbounded
    const char *meaning; ///< a sentence for tooltips and help
};

/// Returns the description of a measure.
const MeasureInfo &infoOf(Measure measure);

/// An edge of a mesh with the elements beside it.
struct MeshEdge {
    NodeId a = kNoNode, b = kNoNode;                              ///< a < b
    std::array<ElementId, 2> elements = {kNoElement, kNoElement}; ///< the second is kNoElement at the boundary
    NodeId middle = kNoNode;                                      ///< of an edge of 3 nodes
};

/// All edges of a mesh, ordered by their nodes.
struct MeshEdges {
    std::vector<MeshEdge> edges;
    HalfEdgeNumbers halfEdges;             ///< of the mesh
    std::vector<std::uint32_t> ofHalfEdge; ///< per half-edge, the index of its edge

    /// Returns the index of edge k of an element, which joins its corner k to the next.
    std::uint32_t of(std::size_t element, std::size_t k) const { return ofHalfEdge[halfEdges.of(element, k)]; }
    /// Returns the indices of the edges of an element, in order.
    std::span<const std::uint32_t> of(std::size_t element) const {
        return std::span(ofHalfEdge).subspan(halfEdges.of(element, 0), halfEdges.sidesOf(element));
    }
};

/// Returns the edges of a mesh. Edges with more than two elements keep the first two.
MeshEdges edgesOf(const MeshView &mesh);

/// Returns the values of a measure, one for each part of its kind, in order; NaN where a part has none: the area ratio
/// of an element without neighbours, the valence of a node that is no corner of an element. The measures of elements
/// are defined in placed_cell.hpp; a curved edge has the length of its curve. `edges`: the edges of the mesh. Without a
/// spacing, the measures that compare with ρ have no values and the result is empty.
std::vector<double> measureValues(Measure measure, const MeshView &mesh, const MeshEdges &edges,
                                  const SpacingField *spacing);

/// Returns the place of a part: the centre of an element, the middle of an edge, a node.
Vec2 placeOf(const MeshView &mesh, const MeshEdges &edges, MeshPart part, std::size_t index);

/// Returns a quantile: the value of rank ⌊fraction·(n−1)⌋, counted from 0. Reorders the values, of which there must be
/// at least one.
template <class Number>
double percentile(std::vector<Number> &values, double fraction) {
    const auto rank = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return static_cast<double>(values[static_cast<std::size_t>(rank)]);
}

/// The percentiles that a summary holds.
inline constexpr std::array<int, 7> kPercentiles = {1, 5, 25, 50, 75, 95, 99};

/// Statistics of the values of a measure.
struct MeasureSummary {
    std::size_t count = 0; ///< of the values that are not NaN; if 0, the other figures are 0
    double minimum = 0.0, maximum = 0.0, mean = 0.0;
    std::array<double, kPercentiles.size()> percentiles{}; ///< see percentile()
};

/// Summarises values; those that are NaN do not count.
MeasureSummary summarise(std::span<const double> values);

/// A histogram over a range of values, linear or logarithmic.
struct MeasureHistogram {
    double from = 0.0, to = 1.0; ///< from < to; both positive if logarithmic
    bool logarithmic = false;
    std::vector<std::uint64_t> bins; ///< of equal width; the first and the last also hold the values outside

    /// Returns the lower end of a bin; for bins.size(), returns `to`.
    double edge(std::size_t bin) const;
    /// Returns the bin that counts a value.
    std::size_t binOf(double value) const;
};

/// Counts values in `bins` bins over [from, to]; those that are NaN do not count.
MeasureHistogram histogramOf(std::span<const double> values, double from, double to, bool logarithmic,
                             std::size_t bins);

/// Returns a number that grows as the value gets worse; NaN for NaN and for measures without bad values.
double badness(BadEnd bad, double value);

/// Returns the parts with the worst values, worst first and equal ones by number, at most `limit`. Empty for measures
/// without bad values.
std::vector<std::uint32_t> worstParts(Measure measure, std::span<const double> values, std::size_t limit);

} // namespace forefront
