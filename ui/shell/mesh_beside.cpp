#include "ui/shell/mesh_beside.hpp"

#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/shell/figure_table.hpp"
#include "ui/shell/small_mesh.hpp"
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

/// The elements in view; none if there are too many to draw one by one, and only the outline is shown.
struct InView {
    std::vector<std::uint32_t> elements;
    bool tooMany = false;
};

InView elementsIn(const ComparedMesh &compared, const Box2 &box) {
    InView view;
    const Judgement &judgement = *compared.judgement();
    const std::size_t all = compared.mesh().elements.size();
    if (!judgement.tree) { // not yet evaluated
        view.tooMany = all > kMaxSmallMesh;
        view.elements.resize(view.tooMany ? 0 : all);
        std::iota(view.elements.begin(), view.elements.end(), 0U);
        return view;
    }
    const auto visit = [&](std::uint32_t element) {
        view.tooMany = view.elements.size() == kMaxSmallMesh;
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

/// Returns the value of an element: its own, or the mean of its nodes; none if the elements are not coloured by a
/// value.
std::optional<double> valueOf(const ComparedMesh &compared, std::size_t element) {
    const Judgement &judgement = *compared.judgement();
    const std::vector<double> &values = judgement.values;
    if (judgement.info.part == MeshPart::Elements) {
        return element < values.size() ? std::optional(values[element]) : std::nullopt;
    }
    if (!judgement.of.fieldValues || values.size() != compared.mesh().nodes.size()) {
        return std::nullopt;
    }
    const Element &nodes = compared.mesh().elements[element];
    return std::accumulate(nodes.begin(), nodes.end(), 0.0,
                           [&](double sum, NodeId node) { return sum + values[index(node)] / 3.0; });
}

/// Returns the colour of an element; as on the canvas, the layer "quality" colours it by its value.
Colour colourOf(Shell &context, const ComparedMesh &compared, std::size_t element) {
    const JudgeRequest &of = compared.judgement()->of, &canvas = context.judgement->of;
    const LayerSlot *const quality = context.layer("quality");
    const bool same = of.measure == canvas.measure && of.field == canvas.field && of.fieldPart == canvas.fieldPart;
    const std::optional<double> value =
        quality != nullptr && quality->visible && same ? valueOf(compared, element) : std::nullopt;
    if (!value) {
        return context.theme.element;
    }
    return mapOf(of.measure)(std::clamp(mapPosition(of.measure, measureRange(context), *value), 0.0, 1.0));
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
    const TriMesh &mesh = compared.mesh();
    const auto at = [&](NodeId node) { return mesh.nodes[index(node)]; };
    const Box2 visible = painter.camera().visible();
    const InView view = elementsIn(compared, visible);
    for (const std::uint32_t number : view.elements) {
        const Element &element = mesh.elements[number];
        const Vec2 a = at(element[0]), b = at(element[1]), c = at(element[2]);
        drawElement(painter, context.theme, a, b, c, colourOf(context, compared, number));
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
