#include "core/engine/mesh/measures.hpp"

#include "core/engine/mesh/edge_table.hpp"
#include "core/engine/mesh/elements_across.hpp"
#include "core/engine/mesh/islands.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "core/engine/spacing/spacing_field.hpp"

namespace forefront {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kUnbounded = std::numeric_limits<double>::infinity();

constexpr std::array<MeasureInfo, wordsOf<Measure>().size()> kMeasureInfos = {{
    {"Shape factor", "\xce\xb1", "", MeshPart::Elements, BadEnd::Low, false, -1.0, 1.0,
     "Shape factor \xce\xb1 = 4\xe2\x88\x9a"
     "3\xc2\xb7"
     "area/\xce\xa3l\xc2\xb2 of each triangle, and the minimum over the corner triangles of a quadrilateral: 1 if "
     "equilateral or square, 0 if flat, negative if inverted"},
    {"Scaled Jacobian", "SJ", "", MeshPart::Elements, BadEnd::Low, false, -1.0, 1.0,
     "Minimum over the corners of each element of the sine of the angle, scaled to 1 for equilateral triangles and "
     "squares, times the distortion by curved edges; not positive if the element folds over itself"},
    {"Minimum angle", "min \xe2\x88\xa0", "\xc2\xb0", MeshPart::Elements, BadEnd::Low, false, 0.0, 90.0,
     "Smallest angle of each element; 0 if it is flat, inverted or not convex"},
    {"Maximum angle", "max \xe2\x88\xa0", "\xc2\xb0", MeshPart::Elements, BadEnd::High, false, 60.0, 180.0,
     "Largest angle of each element; 180 if it is flat, inverted or not convex"},
    {"Aspect ratio", "aspect", "", MeshPart::Elements, BadEnd::High, true, 1.0, kUnbounded,
     "Length over height of each element, such as those of boundary layers: of a quadrilateral, between the middles of "
     "opposite edges; of a triangle, its longest edge over its height, 1 if it is equilateral"},
    {"Area", "area", "", MeshPart::Elements, BadEnd::None, true, -kUnbounded, kUnbounded,
     "Area of each element; negative if it is inverted"},
    {"Area ratio", "growth", "", MeshPart::Elements, BadEnd::High, true, 1.0, kUnbounded,
     "Largest area ratio between each element and the neighbours that share an edge with it"},
    {"Edge length", "length", "", MeshPart::Edges, BadEnd::None, true, 0.0, kUnbounded, "Length of each edge"},
    {"Edge length over \xcf\x81", "L/\xcf\x81", "", MeshPart::Edges, BadEnd::FarFromOne, true, 0.0, kUnbounded,
     "Length of each edge divided by the node spacing \xcf\x81 at its middle; 1 if the edge matches the spacing"},
    {"Spacing conformity", "\xce\xb4", "", MeshPart::Edges, BadEnd::Low, false, 0.0, 1.0,
     "Spacing conformity \xce\xb4 = min(L/\xcf\x81, \xcf\x81/L) of each edge, \xcf\x81 at its middle; 1 if the edge "
     "matches the spacing"},
    {"Elements across", "across", "", MeshPart::Edges, BadEnd::Low, false, 1.0, kUnbounded,
     "Number of elements between facing parts of the boundary, interfaces and inner lines, counted through each edge "
     "halfway between them"},
    {"Island area", "island", "", MeshPart::Edges, BadEnd::Low, true, 0.0, kUnbounded,
     "Area of the island, a hole of the mesh, that each edge of the boundary belongs to"},
    {"Valence", "valence", "", MeshPart::Nodes, BadEnd::High, false, 0.0, kUnbounded,
     "Number of elements around each node; 6 triangles or 4 quadrilaterals are ideal for interior nodes"},
    {"Region", "region", "", MeshPart::Elements, BadEnd::None, false, 1.0, kUnbounded, "Region tag of each element"},
    {"Creation order", "birth", "", MeshPart::Elements, BadEnd::None, false, 0.0, kUnbounded,
     "Number of each element: its position in the file or, until the mesh is improved, the order in which the front "
     "made it"},
}};

template <class Value>
std::vector<double> perElement(const MeshView &mesh, Value &&value) {
    std::vector<double> values(mesh.elementCount());
    forEachCell(mesh, [&](const PlacedCell &cell, std::size_t e) { values[e] = value(cell); });
    return values;
}

std::vector<double> areaRatios(const MeshView &mesh, const MeshEdges &edges) {
    const std::vector<double> areas =
        perElement(mesh, [](const PlacedCell &cell) { return std::abs(twiceArea(cell)); });
    std::vector<double> ratios(areas.size(), kNone);
    for (const MeshEdge &edge : edges.edges) {
        if (edge.elements[1] == kNoElement) {
            continue;
        }
        const std::size_t e = index(edge.elements[0]), f = index(edge.elements[1]);
        const auto [smaller, larger] = std::minmax(areas[e], areas[f]);
        const double ratio = smaller > 0.0 ? larger / smaller : larger > 0.0 ? kUnbounded : 1.0;
        ratios[e] = std::fmax(ratios[e], ratio);
        ratios[f] = std::fmax(ratios[f], ratio);
    }
    return ratios;
}

std::vector<double> lengths(const MeshView &mesh, const MeshEdges &edges) {
    std::vector<double> values(edges.edges.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] = edgeLength(mesh.nodes, edges.edges[k].a, edges.edges[k].middle, edges.edges[k].b);
    }
    return values;
}

/// Returns the lengths of the edges divided by ρ at their middles.
std::vector<double> lengthsOverSpacing(const MeshView &mesh, const MeshEdges &edges, const SpacingField &spacing) {
    constexpr std::size_t kBlock = 512;
    std::array<Vec2, kBlock> middles;
    std::array<double, kBlock> rho;
    std::vector<double> values = lengths(mesh, edges);
    for (std::size_t first = 0; first < values.size(); first += kBlock) {
        const std::size_t count = std::min(kBlock, values.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            middles[i] = placeOf(mesh, edges, MeshPart::Edges, first + i);
        }
        spacing.atMany({middles.data(), count}, {rho.data(), count});
        for (std::size_t i = 0; i < count; ++i) {
            values[first + i] /= rho[i];
        }
    }
    return values;
}

std::vector<double> valences(const MeshView &mesh) {
    std::vector<double> values(mesh.nodes.size(), 0.0);
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            for (const NodeId corner : block.nodesOf(k).first(block.traits().corners)) {
                values[index(corner)] += 1.0;
            }
        }
    }
    std::replace(values.begin(), values.end(), 0.0, kNone);
    return values;
}

std::vector<double> perElementIndex(std::size_t count, auto &&value) {
    std::vector<double> values(count);
    for (std::size_t e = 0; e < count; ++e) {
        values[e] = static_cast<double>(value(e));
    }
    return values;
}

} // namespace

const MeasureInfo &infoOf(Measure measure) {
    return kMeasureInfos[static_cast<std::size_t>(measure)];
}

MeshEdges edgesOf(const MeshView &mesh) {
    MeshEdges result;
    result.edges.reserve(mesh.nodes.size() + mesh.elementCount());
    const EdgeTable table(mesh);
    const HalfEdges &halfEdges = table.halfEdges();
    result.halfEdges = HalfEdgeNumbers(mesh);
    result.ofHalfEdge.resize(halfEdges.count());
    table.forEach([&](NodeId a, NodeId b, std::span<const HalfEdge> sides) {
        const auto number = static_cast<std::uint32_t>(result.edges.size());
        MeshEdge edge{a, b};
        for (std::size_t i = 0; i < sides.size(); ++i) {
            result.ofHalfEdge[sides[i]] = number;
            if (i < 2) {
                edge.elements[i] = ElementId{static_cast<std::uint32_t>(halfEdges.elementOf(sides[i]))};
            }
        }
        edge.middle = halfEdges.middleOf(sides[0]);
        result.edges.push_back(edge);
    });
    return result;
}

std::vector<double> measureValues(Measure measure, const MeshView &mesh, const MeshEdges &edges,
                                  const SpacingField *spacing) {
    switch (measure) {
    case Measure::ShapeFactor:
        return perElement(mesh, [](const PlacedCell &cell) { return shapeFactor(cell); });
    case Measure::ScaledJacobian:
        return perElement(mesh, scaledJacobian);
    case Measure::MinAngle:
        return perElement(mesh, [](const PlacedCell &cell) { return anglesOf(cell).smallest; });
    case Measure::MaxAngle:
        return perElement(mesh, [](const PlacedCell &cell) { return anglesOf(cell).largest; });
    case Measure::Aspect:
        return perElement(mesh, aspectRatio);
    case Measure::Area:
        return perElement(mesh, [](const PlacedCell &cell) { return 0.5 * twiceArea(cell); });
    case Measure::AreaRatio:
        return areaRatios(mesh, edges);
    case Measure::Length:
        return lengths(mesh, edges);
    case Measure::SizeRatio:
    case Measure::Conformity: {
        std::vector<double> values;
        if (spacing != nullptr) {
            values = lengthsOverSpacing(mesh, edges, *spacing);
        }
        if (measure == Measure::Conformity) {
            std::transform(values.begin(), values.end(), values.begin(), [](double r) { return std::min(r, 1.0 / r); });
        }
        return values;
    }
    case Measure::Across:
        return elementsAcross(mesh, edges);
    case Measure::IslandArea: {
        std::vector<double> values(edges.edges.size(), kNone);
        for (const MeshIsland &island : islandsOf(mesh, edges)) {
            for (const std::uint32_t edge : island.edges) {
                values[edge] = island.area;
            }
        }
        return values;
    }
    case Measure::Valence:
        return valences(mesh);
    case Measure::Region:
        return perElementIndex(mesh.elementCount(), [&](std::size_t e) { return mesh.region(e); });
    case Measure::Birth:
        return perElementIndex(mesh.elementCount(), [](std::size_t e) { return e; });
    }
    return {};
}

Vec2 placeOf(const MeshView &mesh, const MeshEdges &edges, MeshPart part, std::size_t number) {
    switch (part) {
    case MeshPart::Elements:
        return PlacedCell(mesh, number).centre();
    case MeshPart::Edges: {
        const MeshEdge &edge = edges.edges[number];
        return edge.middle != kNoNode ? mesh.nodes[index(edge.middle)]
                                      : midpoint(mesh.nodes[index(edge.a)], mesh.nodes[index(edge.b)]);
    }
    case MeshPart::Nodes:
        break;
    }
    return mesh.nodes[number];
}

MeasureSummary summarise(std::span<const double> values) {
    std::vector<double> present;
    present.reserve(values.size());
    std::copy_if(values.begin(), values.end(), std::back_inserter(present), [](double v) { return !std::isnan(v); });
    MeasureSummary summary;
    summary.count = present.size();
    if (present.empty()) {
        return summary;
    }
    double sum = 0.0;
    for (const double value : present) {
        sum += value;
    }
    summary.mean = sum / static_cast<double>(present.size());
    const auto [low, high] = std::minmax_element(present.begin(), present.end());
    summary.minimum = *low;
    summary.maximum = *high;
    for (std::size_t i = 0; i < kPercentiles.size(); ++i) {
        summary.percentiles[i] = percentile(present, 0.01 * kPercentiles[i]);
    }
    return summary;
}

double MeasureHistogram::edge(std::size_t bin) const {
    const double t = static_cast<double>(bin) / static_cast<double>(bins.size());
    return logarithmic ? from * std::pow(to / from, t) : (1.0 - t) * from + t * to;
}

std::size_t MeasureHistogram::binOf(double value) const {
    // Works with halves, since the difference of two large numbers may overflow.
    const double t = logarithmic ? value > 0.0 ? std::log(value / from) / std::log(to / from) : 0.0
                                 : (0.5 * value - 0.5 * from) / (0.5 * to - 0.5 * from);
    const auto count = static_cast<double>(bins.size());
    return t > 0.0 ? std::min(static_cast<std::size_t>(std::min(t, 1.0) * count), bins.size() - 1) : 0;
}

MeasureHistogram histogramOf(std::span<const double> values, double from, double to, bool logarithmic,
                             std::size_t bins) {
    MeasureHistogram histogram{from, to, logarithmic, std::vector<std::uint64_t>(bins, 0)};
    for (const double value : values) {
        if (!std::isnan(value)) {
            ++histogram.bins[histogram.binOf(value)];
        }
    }
    return histogram;
}

double badness(BadEnd bad, double value) {
    switch (bad) {
    case BadEnd::Low:
        return -value;
    case BadEnd::High:
        return value;
    case BadEnd::FarFromOne:
        return value > 0.0 ? std::abs(std::log(value)) : kUnbounded;
    case BadEnd::None:
        break;
    }
    return kNone;
}

std::vector<std::uint32_t> worstParts(Measure measure, std::span<const double> values, std::size_t limit) {
    struct Ranked {
        double badness;
        std::uint32_t part;
        bool operator<(const Ranked &other) const {
            return badness != other.badness ? badness > other.badness : part < other.part;
        }
    };
    std::vector<Ranked> ranked;
    ranked.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double bad = badness(infoOf(measure).bad, values[i]);
        if (!std::isnan(bad)) {
            ranked.push_back({bad, static_cast<std::uint32_t>(i)});
        }
    }
    limit = std::min(limit, ranked.size());
    std::partial_sort(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(limit), ranked.end());
    std::vector<std::uint32_t> parts(limit);
    std::transform(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(limit), parts.begin(),
                   [](const Ranked &entry) { return entry.part; });
    return parts;
}

} // namespace forefront
