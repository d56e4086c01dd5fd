#include "tests/unit/io_samples.hpp"

#include "core/drawing/formulas/formulas.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "core/files/common/names.hpp"
#include "tests/support/number_literal.hpp"
#include "tests/unit/mesh_samples.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace forefront::testing {

namespace {

Shape shape(std::uint32_t id, ShapeKind kind, ShapeUse use, std::vector<Vec2> nodes, std::string name) {
    Shape result;
    result.id = id;
    result.form = formOf(kind);
    result.use = use;
    result.nodes = std::move(nodes);
    result.tag = static_cast<std::int32_t>(id);
    result.name = std::move(name);
    return result;
}

PaintedSpacing paintedPatch() {
    PaintedSpacing paint;
    paint.origin = {-0.1, 1e-17};
    paint.pitch = 0.3;
    for (const int tileNumber : {-1, 0, 70000}) {
        PaintedSpacing::Tile tile{};
        for (std::size_t k = 0; k < tile.size(); ++k) {
            tile[k] = k % 5 == 0 ? 0.0F : 0.1F + 0.01F * static_cast<float>(std::sin(static_cast<double>(k / 3)) + 1.0);
        }
        paint.tiles.emplace(std::pair(tileNumber, -tileNumber), std::make_shared<const PaintedSpacing::Tile>(tile));
    }
    paint.tiles.emplace(std::pair(5, 5), std::make_shared<const PaintedSpacing::Tile>());
    return paint;
}

} // namespace

Document fullDocument() {
    Document document;
    Shape outline = shape(1, ShapeKind::Polygon, ShapeUse::Boundary, {{0, 0}, {4, 0}, {4, 3.1}, {1.0 / 3.0, 3}},
                          "quay \"north\" \\ Ä\n");
    outline.segmentTags = {1, 2, 2, 7};
    outline.nodeSizes = {{1, {1.0 / 3.0, 0.3}}, {3, {0.05, 0.0}}};
    Shape sail = shape(10, ShapeKind::Polygon, ShapeUse::Constraint, {{2, 1}, {2.5, 1.1}, {2.1, 1.2}}, "sail");
    sail.path().curves = {Curve::cubic({2, 1}, {1.0 / 3.0 + 2.0, 0.9}, {2.4, 1}, {2.5, 1.1}),
                          joining(Curve::arc({0, 0}, {1, 0}, {0, 1}, 0.1, 1.0 / 3.0), {2.5, 1.1}, {2.1, 1.2}),
                          {}};
    sail.hidden = true;
    sail.cuts = {{0.25, 2.0 / 3.0}, {}, {}};
    Shape pier = shape(4, ShapeKind::Polyline, ShapeUse::Constraint, {{1, 1}, {1.5, 1}, {2, 1.25}}, "pier");
    Shape box = shape(2, ShapeKind::Rectangle, ShapeUse::Boundary, {{3, 1}, {3.5, 2}}, "");
    box.as<RectangleForm>().radius = 0.1;
    box.locked = true;
    box.segmentSizes = {{0, {.size = 0.05, .growth = 0.3}}, {5, {.elements = 7, .growth = 0.0, .bias = {4.0, true}}}};
    for (const Shape &item :
         {outline, box, shape(3, ShapeKind::Circle, ShapeUse::Boundary, {{1, 2}, {1.2, 2}}, "island"), pier,
          shape(9, ShapeKind::Point, ShapeUse::Constraint, {{2.5, 0.5}}, "gauge"), sail,
          shape(11, ShapeKind::Ellipse, ShapeUse::Boundary, {{2, 2}, {2.2, 2}, {2, 2.1}}, "")}) {
        document.shapes.push_back(std::make_shared<const Shape>(item));
    }
    document.regionMarkers = {{{0.5, 0.5}, 3, 0.0, 0.1, 0.3}, {{-1e-300, 1e300}, 1}};
    document.boundaryNames = {{1, "wall"}, {7, "inlet"}};
    document.regionNames = {{3, "water"}};
    document.spacing.segmentsPerTurn = 24.0;
    document.spacing.elementsAcross = 3.5;
    document.spacing.size = 0.1;
    document.spacing.expression = "max(0.1, \"x\"*x)";
    document.spacing.sources = {{SourceShape::Point, {1, 2}, {}, 0.0, 0.05, 0.3, "head"},
                                {SourceShape::Line, {1, 2}, {3, 4}, 0.5, 0.05, 0.0, "", 1.0 / 3.0},
                                {SourceShape::Circle, {1, 2}, {}, 0.25, 0.01, 0.2, "disc"},
                                {SourceShape::Box, {1, 2}, {3, 5}, 0.0, 0.01, 0.2, "box", {}, 1.0 / 3.0}};
    document.spacing.keepAutomatic = true;
    document.spacing.paint = paintedPatch();
    document.spacing.background = std::make_shared<const BackgroundMesh>(
        BackgroundMesh{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{0, 1, 2}, {2, 1, 3}}, {0.1, 0.2, 0.3, 0.4}});
    document.spacing.partSizes = {{7, {0.05, 0.3}}, {9, {0.2, 0.0}}};
    document.elementCounts = {{10, {24, 0.1}}, {11, {7, 0.0}}};
    document.parameters = {{"half", "h/2"}, {"h", "0.1"}};
    document.spacing.names = parameterValues(document.parameters);
    document.formulas = {
        {"shape/2/radius"_number, "h"}, {"source/0/size"_number, "half"}, {"spacing/size"_number, "h"}};
    document.spacing.fromBoundary = true;
    document.spacing.minimum = 1e-3;
    document.spacing.maximum = 12.5;
    document.spacing.gradation = 0.3;
    document.options.grid = GridKind::Uniform;
    document.options.gridColumns = 12;
    document.options.gridRows = 7;
    document.options.keepBoundary = true;
    document.options.improve = ImproveLevel::Best;
    document.options.threads = 3;
    document.options.maxElements = 123'456;
    document.options.elements = Elements::Mixed;
    document.options.order = ElementOrder::Second;
    document.options.quadNodes = QuadNodes::Nine;
    document.options.leastAngle = 27.5;
    for (const MeshLimit limit : valuesOf<MeshLimit>()) {
        document.limits[limit] = std::max(limitInfo(limit).isMinimum ? 0.5 : 70.5, limitInfo(limit).minimum);
    }
    document.picture = BackgroundPicture{"/maps/\"sea\" chart.png", {-3.0, 0.1}, {40.0, 30.5}, 0.25, true, 12.5};
    document.circleTolerance = 0.01;
    document.curveTolerance = 0.001;
    document.openBoundaries = {7, 9};
    document.elevation = "-5 - \"x\"*x";
    document.nextId = 12;
    return document;
}

TriMesh twoRegionMesh(std::size_t columns, std::size_t rows) {
    TriMesh mesh = samples::square(columns, rows, 0.2, {1.0 / 3.0, -1e-3}, 7);
    const std::size_t middle = columns / 2;
    const auto at = [&](std::size_t i, std::size_t j) { return samples::node(j * (columns + 1) + i); };
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        mesh.regions.push_back((e / 2) % columns < middle ? 2 : 5);
    }
    for (std::size_t j = 0; j < rows; ++j) {
        mesh.edges.push_back({at(middle, j), at(middle, j + 1), 9});
    }
    mesh.edges.push_back({at(1, 1), at(2, 1), 6});
    mesh.points.push_back({at(columns - 1, rows - 1), 11});
    mesh.boundaryNames = {{1, "sea bed"}, {2, "outlet \"east\""}, {3, "Öffnung"}, {9, "interface"}, {11, "gauge"}};
    mesh.regionNames = {{2, "water"}, {5, "Water"}};
    return mesh;
}

std::string difference(const TriMesh &a, const TriMesh &b) {
    // Formats that collect edges and points by tag change their order, which means nothing.
    const auto edgesOf = [](const TriMesh &mesh) {
        std::set<std::tuple<NodeId, NodeId, std::int32_t>> edges;
        for (const TaggedEdge &edge : mesh.edges) {
            edges.emplace(std::min(edge.a, edge.b), std::max(edge.a, edge.b), edge.tag);
        }
        return edges;
    };
    const auto pointEqual = [](const TaggedNode &x, const TaggedNode &y) { return x.node == y.node && x.tag == y.tag; };
    const auto sameList = [](const auto &x, const auto &y, auto equal) {
        return std::equal(x.begin(), x.end(), y.begin(), y.end(), equal);
    };
    std::string text;
    text += a.nodes == b.nodes ? "" : "nodes ";
    text += a.elements == b.elements ? "" : "elements ";
    text += edgesOf(a) == edgesOf(b) && a.edges.size() == b.edges.size() ? "" : "edges ";
    text += sameList(a.points, b.points, pointEqual) ? "" : "points ";
    for (std::size_t e = 0; e < std::min(a.elements.size(), b.elements.size()); ++e) {
        if (a.region(e) != b.region(e)) {
            text += "regions ";
            break;
        }
    }
    const TagList tagsA = tagsOf(a);
    const TagList tagsB = tagsOf(b);
    const auto quoted = [](std::map<std::int32_t, std::string> names) {
        for (auto &[tag, name] : names) {
            name = asQuotable(name);
        }
        return names;
    };
    text += quoted(tagsA.edges) == quoted(tagsB.edges) ? "" : "edge-names ";
    text += quoted(tagsA.points) == quoted(tagsB.points) ? "" : "point-names ";
    text += quoted(tagsA.regions) == quoted(tagsB.regions) ? "" : "region-names ";
    return text;
}

void undoRounding(TriMesh &back, const TriMesh &mesh, const Diagnostics &notes) {
    constexpr double kRounding = 1e-11; // of 12 digits at least
    for (std::size_t n = 0; hasCode(notes, "rounded-coordinates") && n < std::min(back.nodes.size(), mesh.nodes.size());
         ++n) {
        const Vec2 a = back.nodes[n], b = mesh.nodes[n];
        if (std::fabs(a.x - b.x) <= kRounding * std::fabs(b.x) && std::fabs(a.y - b.y) <= kRounding * std::fabs(b.y)) {
            back.nodes[n] = b;
        }
    }
}

std::string written(void (*write)(const MeshView &, TextWriter &), const MeshView &mesh) {
    StringSink sink;
    TextWriter out(sink);
    write(mesh, out);
    out.flush();
    return std::move(sink.text);
}

std::string written(const Format &format, const MeshView &mesh) {
    StringSink sink;
    TextWriter out(sink);
    format.write(mesh, {}, out);
    out.flush();
    return std::move(sink.text);
}

std::string messages(const Diagnostics &faults) {
    std::string text;
    for (const Diagnostic &fault : faults) {
        text += toString(fault) + '\n';
    }
    return text;
}

bool allLocated(const Diagnostics &faults) {
    return std::all_of(faults.begin(), faults.end(), [](const Diagnostic &fault) {
        return !fault.file.empty() && fault.line > 0 && fault.column > 0;
    });
}

} // namespace forefront::testing
