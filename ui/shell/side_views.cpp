#include "core/teaching/moment/moment.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/dialogs/open_mesh.hpp"
#include "ui/shell/figure_table.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/mesh_beside.hpp"
#include "ui/shell/small_mesh.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace forefront::shell {

namespace {

constexpr double kTitleHeight = 26.0; ///< design pixels
constexpr double kZoomStep = 1.18;

constexpr std::array<FigureColumn, 7> kRunColumns{
    {{"advances", "Advances", "Advances of the front so far"},
     {"elements", "Ne", "Elements made so far"},
     {"front", "Nb", "Mean number of segments on the front"},
     {"neighbours", "Nc", "Mean number of neighbouring segments that the background grid returns per element"},
     {"considered", "Ns", "Mean number of segments near enough to be considered per element, for each candidate side"},
     {"tests", "Nt", "Mean number of exact intersection tests per element"},
     {"cells", "Cells", "Mean number of cells of the background grid visited per element"}}};

FigureRow rowOf(std::string name, const SessionSnapshot &run) {
    const RunFigures f = figuresOf(run);
    return {std::move(name),
            {static_cast<double>(f.advances), static_cast<double>(f.elements), f.front, f.neighbours, f.considered,
             f.tests, f.cells}};
}

/// Draws a run with the camera of its view.
class RunPicture {
  public:
    RunPicture(CanvasPainter &painter, const Theme &theme, const SessionSnapshot &run)
        : painter_(painter), theme_(theme), run_(run), visible_(painter.camera().visible()) {}

    void draw(bool cells) {
        if (run_.mesh && run_.mesh->mesh.elements.size() <= kMaxSmallMesh) {
            drawElements(run_.mesh->mesh);
        }
        if (cells && run_.cells) {
            for (const GridCellView &cell : *run_.cells) {
                if (cell.entries > 0 && cell.box.overlaps(visible_)) {
                    painter_.rectangle(cell.box, fade(theme_.cell, 0.6));
                }
            }
        }
        if (run_.mesh) {
            for (const TaggedEdge &edge : run_.mesh->mesh.edges) {
                line(at(edge.a), at(edge.b), theme_.boundary, 1.5);
            }
        }
        if (run_.front) {
            for (const FrontSegmentView &segment : *run_.front) {
                line(segment.a, segment.b, theme_.front, 2.0);
            }
        }
        drawAdvance();
    }

  private:
    Vec2 at(NodeId node) const { return run_.mesh->mesh.nodes[index(node)]; }
    void line(Vec2 a, Vec2 b, Colour colour, double width) {
        if (boxOf(a, b).overlaps(visible_)) {
            painter_.line(a, b, colour, width);
        }
    }
    void drawElements(const TriMesh &mesh) {
        for (const Element &element : mesh.elements) {
            const Vec2 a = at(element[0]), b = at(element[1]), c = at(element[2]);
            Box2 box = boxOf(a, b);
            box.add(c);
            if (box.overlaps(visible_)) {
                drawElement(painter_, theme_, a, b, c, theme_.element);
            }
        }
    }
    /// Draws the base of the advance, its candidates and the cells that its searches visited.
    void drawAdvance() {
        const Moment moment = momentOf(run_);
        if (!moment) {
            return;
        }
        for (std::size_t k = 0; k < moment.cells; ++k) {
            painter_.rectangle(moment.advance->cells[k], theme_.visited, 1.5);
        }
        for (std::size_t k = 0; k < moment.candidates; ++k) {
            painter_.dot(moment.advance->candidates[k].position, 3.0, theme_.candidate);
        }
        painter_.line(moment.advance->a, moment.advance->b, theme_.base, 3.0);
    }

    CanvasPainter &painter_;
    const Theme &theme_;
    const SessionSnapshot &run_;
    Box2 visible_;
};

/// Pans and zooms the shared camera when the pointer drags or scrolls over a view. The canvas moves in the same way,
/// about its own centre.
void moveCamera(Shell &context, const PixelRect &rect) {
    if (!ImGui::IsWindowHovered()) {
        return;
    }
    const ImGuiIO &io = ImGui::GetIO();
    const PixelRect &canvas = context.view.camera.viewport;
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left) || ImGui::IsMouseDown(ImGuiMouseButton_Middle)) {
        if (io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F) {
            context.view.pan({static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y)});
        }
    }
    if (io.MouseWheel != 0.0F) {
        const Pixel offset = Pixel(io.MousePos.x, io.MousePos.y) - rect.centre();
        context.view.zoomAt(canvas.centre() + offset, std::pow(kZoomStep, static_cast<double>(io.MouseWheel)));
    }
}

void drawView(Shell &context, std::size_t number, const PixelRect &rect) {
    const std::string id = "sides/" + std::to_string(number);
    beginRegion(("##" + id).c_str(), rect, context.theme.canvas, 0, 0);
    ui::markWindow(context, id);
    moveCamera(context, rect);
    Camera camera = context.view.camera;
    camera.viewport = rect;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    CanvasPainter painter(list, camera, static_cast<double>(context.scale));
    if (context.sides.mesh() != nullptr) {
        drawMeshBeside(context, painter);
    } else {
        const LayerSlot *const grid = context.layer("grid");
        RunPicture(painter, context.theme, context.sides.now(number)).draw(grid != nullptr && grid->visible);
    }
    const std::string title =
        context.sides.mesh() != nullptr ? context.sides.mesh()->name() : context.sides.variant(number).name();
    const ImVec2 corner{static_cast<float>(rect.x), static_cast<float>(rect.y)};
    const float right = corner.x + static_cast<float>(rect.width);
    list.AddRectFilled(corner, {right, corner.y + context.px(kTitleHeight)}, fade(context.theme.panel, 0.92));
    list.AddText({corner.x + context.px(10), corner.y + context.px(5)}, context.theme.text, title.c_str());
    list.AddLine(corner, {corner.x, corner.y + static_cast<float>(rect.height)}, context.theme.line);
    ImGui::End();
}

/// Draws the choice between a mesh beside the canvas and one laid over it.
void drawArrangement(Shell &context) {
    int choice = context.sides.overlaid ? 1 : 0;
    const char *const names[] = {"Side by side", "Overlaid"};
    const char *const tips[] = {"Show the other mesh beside the canvas, with the same camera",
                                "Draw the edges of the other mesh over the mesh on the canvas"};
    if (ui::segmented(context, "sides/arrangement", names, choice, 240.0F, tips)) {
        context.sides.overlaid = choice == 1;
        context.animate();
    }
    ImGui::SameLine(0, context.px(12));
}

/// Draws the choice of what to compare with the run on the canvas.
void drawChoice(Shell &context) {
    if (const ComparedMesh *const mesh = context.sides.mesh(); mesh != nullptr) {
        drawArrangement(context);
        if (ui::button(context, "sides/other", "Other mesh\xe2\x80\xa6")) {
            compareMesh(context);
        }
        if (context.sides.overlaid) {
            ImGui::SameLine(0, context.px(12));
            ImGui::AlignTextToFramePadding();
            ImGui::PushStyleColor(ImGuiCol_Text, context.theme.compared);
            ImGui::TextUnformatted(("edges of " + mesh->name()).c_str());
            ImGui::PopStyleColor();
            ui::mark(context, "sides/key");
        }
        return;
    }
    int choice = static_cast<int>(context.sides.comparison);
    const char *const names[] = {"Background grids", "Methods"};
    const char *const tips[] = {"The same method with the other background grids",
                                "The other method with the same background grid"};
    if (ui::segmented(context, "sides/comparison", names, choice, 240.0F, tips)) {
        context.sides.comparison = static_cast<Comparison>(choice);
        context.animate();
    }
}

/// Draws a row for each run and a column for each figure.
void drawRunTable(Shell &context) {
    std::vector<FigureRow> rows{rowOf("on the canvas", context.run.now())};
    for (std::size_t k = 0; k < context.sides.size(); ++k) {
        rows.push_back(rowOf(context.sides.variant(k).name(), context.sides.now(k)));
        rows.back().comparable = samePosition(context.run.now(), context.sides.now(k));
    }
    drawFigureTable(context, kRunColumns, rows);
}

void drawFigures(Shell &context, const PixelRect &rect) {
    beginRegion("##sidesTable", rect, context.theme.panel, context.px(10), context.px(6));
    ImGui::PushFont(context.fonts.small);
    const ImVec2 start = ImGui::GetCursorPos();
    ImGui::SetCursorPosX(ImGui::GetWindowWidth() - context.px(34));
    const bool closed =
        ui::iconButton(context, "sides/close", icon::kCross, "Close the comparison", false, true, 24.0F);
    ImGui::SetCursorPos(start);
    drawChoice(context);
    context.sides.mesh() != nullptr ? drawMeshTable(context) : drawRunTable(context);
    ImGui::PopFont();
    ImGui::End();
    if (closed) {
        context.sides.close();
        context.animate();
    }
}

} // namespace

void drawSides(Shell &context, const PixelRect &views, const PixelRect &table) {
    if (!context.sides.visible || context.sides.size() == 0) {
        return;
    }
    const std::size_t count = context.sides.views();
    const double width = std::floor(views.width / static_cast<double>(std::max<std::size_t>(1, count)));
    for (std::size_t k = 0; k < count; ++k) {
        drawView(context, k, {views.x + static_cast<double>(k) * width, views.y, width, views.height});
    }
    drawFigures(context, table);
}

} // namespace forefront::shell
