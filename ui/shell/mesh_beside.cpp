#include "ui/shell/mesh_beside.hpp"

#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/shell/figure_table.hpp"
#include "ui/style/measure_colours.hpp"
#include "ui/workspace/judging.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront::shell {

namespace {

/// Maximum number of elements drawn; with more in view, only the outline is shown.
constexpr std::size_t kMaxDrawn = 12'000;

/// The elements in view; none if there are too many to draw.
struct InView {
    std::vector<std::uint32_t> elements;
    bool tooMany = false;
};

InView elementsIn(const ComparedMesh &compared, const Box2 &box) {
    InView view;
    const Judgement &judgement = *compared.judgement();
    const std::size_t all = compared.mesh().elements.size();
    if (!judgement.tree) { // not yet evaluated
        view.tooMany = all > kMaxDrawn;
        view.elements.resize(view.tooMany ? 0 : all);
        std::iota(view.elements.begin(), view.elements.end(), 0U);
        return view;
    }
    const auto visit = [&](std::uint32_t element) {
        view.tooMany = view.elements.size() == kMaxDrawn;
        if (!view.tooMany) {
            view.elements.push_back(element);
        }
        return !view.tooMany;
    };
    judgement.tree->search([&](const Box2 &other) { return other.overlaps(box); }, visit);
    if (view.tooMany) {
        view.elements.clear();
    }
    return view;
}

/// Returns the colour of an element; as on the canvas, the layer "quality" colours it by its value.
Colour colourOf(const Shell &context, const Judgement &judgement, std::size_t element, bool coloured) {
    const Measure measure = judgement.of.measure;
    if (!coloured || element >= judgement.values.size()) {
        return context.theme.element;
    }
    const double at = mapPosition(measure, measureRange(context), judgement.values[element]);
    return mapOf(measure)(std::clamp(at, 0.0, 1.0));
}

constexpr std::array<FigureColumn, 8> kMeshColumns{
    {{"nodes", "Nodes", "Number of nodes"},
     {"elements", "Elements", "Number of triangles"},
     {"alphaMean", "Mean \xce\xb1", "Mean shape factor \xce\xb1"},
     {"alphaMin", "Minimum \xce\xb1", "Minimum shape factor \xce\xb1"},
     {"minAngle", "Minimum angle", "Smallest angle of all triangles, in degrees"},
     {"maxAngle", "Maximum angle", "Largest angle of all triangles, in degrees"},
     {"delta", "Mean \xce\xb4", "Mean conformity of the edges to the node spacing of the canvas"},
     {"time", "Time, ms", "CPU time taken by the meshing, if known"}}};

FigureRow rowOf(std::string name, const std::optional<MeshFigures> &figures) {
    FigureRow row{std::move(name), std::vector<std::optional<double>>(kMeshColumns.size())};
    if (figures) {
        const MeshQuality &q = figures->quality;
        row.figures = {static_cast<double>(q.nodes),
                       static_cast<double>(q.elements),
                       q.alphaMean,
                       q.alphaMin,
                       q.minAngle,
                       q.maxAngle,
                       std::nullopt,
                       std::nullopt};
        if (figures->spacing) {
            row.figures[6] = q.deltaMean;
        }
        if (figures->seconds) {
            row.figures[7] = 1e3 * *figures->seconds;
        }
    }
    return row;
}

} // namespace

void drawMeshBeside(Shell &context, CanvasPainter &painter) {
    const ComparedMesh &compared = *context.sides.mesh();
    const Mesh &mesh = compared.mesh();
    const Judgement &judgement = *compared.judgement();
    const auto at = [&](NodeId node) { return mesh.nodes[index(node)]; };
    const Box2 visible = painter.camera().visible();
    const InView view = elementsIn(compared, visible);
    const LayerSlot *const quality = context.layer("quality");
    const bool coloured = quality != nullptr && quality->visible && judgement.info.part == MeshPart::Elements;
    for (const std::uint32_t number : view.elements) {
        const Element &element = mesh.elements[number];
        const Vec2 a = at(element[0]), b = at(element[1]), c = at(element[2]);
        painter.triangle(a, b, c, colourOf(context, judgement, number, coloured));
        painter.line(a, b, context.theme.mesh, 1.0);
        painter.line(b, c, context.theme.mesh, 1.0);
        painter.line(c, a, context.theme.mesh, 1.0);
    }
    for (const MeshEdge &edge : compared.outline()) {
        if (boxOf(at(edge.a), at(edge.b)).overlaps(visible)) {
            painter.line(at(edge.a), at(edge.b), context.theme.boundary, 1.5);
        }
    }
    if (view.tooMany) {
        painter.label(painter.camera().centre, {-90, -8}, "Zoom in to see the elements", context.theme.text,
                      context.theme.popup, context.fonts.small);
    }
}

void drawMeshTable(Shell &context) {
    const ComparedMesh &compared = *context.sides.mesh();
    const SessionSnapshot &shown = context.run.now();
    std::optional<MeshFigures> ours = figuresOf(*context.judgement);
    if (ours && !context.run.showsFile() && shown.complete) {
        ours->seconds = shown.secondsMesh + shown.secondsImprove;
    }
    const std::array<FigureRow, 2> rows{rowOf("on the canvas", ours),
                                        rowOf(compared.name(), figuresOf(*compared.judgement()))};
    drawFigureTable(context, kMeshColumns, rows);
}

} // namespace forefront::shell
