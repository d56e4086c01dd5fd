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

/// The triangles in view; none if there are too many to draw one by one, and only the outline is shown.
struct InView {
    std::vector<std::uint32_t> triangles;
    bool tooMany = false;
};

InView trianglesIn(const ComparedMesh &compared, const Box2 &box) {
    InView view;
    const Judgement &judgement = *compared.judgement();
    const std::size_t all = compared.mesh().elements.size();
    if (!judgement.tree) { // not yet evaluated
        view.tooMany = all > kMaxSmallMesh;
        view.triangles.resize(view.tooMany ? 0 : all);
        std::iota(view.triangles.begin(), view.triangles.end(), 0U);
        return view;
    }
    const auto visit = [&](std::uint32_t triangle) {
        view.tooMany = view.triangles.size() == kMaxSmallMesh;
        if (!view.tooMany) {
            view.triangles.push_back(triangle);
        }
        return !view.tooMany;
    };
    judgement.tree->search([&](const Box2 &other) { return other.overlaps(box); }, visit);
    if (view.tooMany) {
        view.triangles.clear();
    }
    return view;
}

/// Returns the value of a triangle: that of its element, or the mean of its nodes; none if the elements are not
/// coloured by a value.
std::optional<double> valueOf(const ComparedMesh &compared, std::size_t triangle) {
    const Judgement &judgement = *compared.judgement();
    const std::vector<double> &values = judgement.values;
    if (judgement.info.part == MeshPart::Elements) {
        const std::size_t element = compared.view()->element(triangle);
        return element < values.size() ? std::optional(values[element]) : std::nullopt;
    }
    if (!judgement.of.fieldValues || values.size() != compared.mesh().nodes.size()) {
        return std::nullopt;
    }
    const Element &nodes = compared.mesh().elements[triangle];
    return std::accumulate(nodes.begin(), nodes.end(), 0.0,
                           [&](double sum, NodeId node) { return sum + values[index(node)] / 3.0; });
}

/// Returns the colour of a triangle; as on the canvas, the layer "quality" colours it by its value.
Colour colourOf(Shell &context, const ComparedMesh &compared, std::size_t triangle) {
    const JudgeRequest &of = compared.judgement()->of, &canvas = context.judgement->of;
    const LayerSlot *const quality = context.layer("quality");
    const bool same = of.measure == canvas.measure && of.field == canvas.field && of.fieldPart == canvas.fieldPart;
    const std::optional<double> value =
        quality != nullptr && quality->visible && same ? valueOf(compared, triangle) : std::nullopt;
    if (!value) {
        return context.theme.element;
    }
    return measureMap(context)(std::clamp(mapPosition(of.measure, measureRange(context), *value), 0.0, 1.0));
}

constexpr std::array<FigureColumn, 8> kMeshColumns{
    {{"nodes", "Nodes", "Number of nodes"},
     {"elements", "Elements", "Number of elements"},
     {"alphaMean", "Mean \xce\xb1", "Mean shape factor \xce\xb1"},
     {"alphaMin", "Minimum \xce\xb1", "Minimum shape factor \xce\xb1"},
     {"minAngle", "Minimum angle", "Smallest angle of all elements, in degrees"},
     {"maxAngle", "Maximum angle", "Largest angle of all elements, in degrees"},
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
    const InView view = trianglesIn(compared, visible);
    for (const std::uint32_t number : view.triangles) {
        const Element &element = mesh.elements[number];
        const std::array<Vec2, 3> corners{at(element[0]), at(element[1]), at(element[2])};
        painter.triangle(corners[0], corners[1], corners[2], colourOf(context, compared, number));
        for (std::size_t k = 0; k < 3; ++k) {
            if (compared.view()->isReal(number, k)) {
                painter.line(corners[k], corners[(k + 1) % 3], context.theme.mesh, 1.0);
            }
        }
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
