#include "core/drawing/commands/mesh_constraints.hpp"
#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/judging.hpp"

#include <imgui.h>

#include <algorithm>
#include <string>

namespace forefront {

namespace {

constexpr std::int32_t kConstraintTag = 2; ///< of pinned nodes and kept edges, as for drawn constraints

class ProbePanel final : public Panel {
  public:
    const char *id() const override { return "probe"; }
    const char *title() const override { return "Probe"; }

    void draw(Shell &context) override {
        const std::shared_ptr<const Judgement> judgement = context.judgement;
        if (!judgement->of.mesh) {
            ui::small(context, "Mesh the drawing, or open a mesh, to read values from its elements, edges and nodes.",
                      true);
            ui::mark(context, "probe/empty");
            return;
        }
        const float top = ImGui::GetCursorPosY();
        ImGui::PushFont(context.fonts.small);
        drawRanking(context, *judgement);
        const std::optional<MeshPick> pick = context.probe.chosen ? context.probe.chosen : context.probe.hovered;
        if (!pick) {
            ui::small(context,
                      context.probe.active
                          ? "Point at the mesh; click an element, edge or node to keep it in view here."
                          : "Press I, then point at an element, edge or node of the mesh.",
                      true);
            ui::mark(context, "probe/hint");
        } else {
            drawPart(context, *pick);
        }
        ImGui::PopFont();
        constexpr double kReserved = 250.0; // design pixels, as for most parts: nothing moves when one is shown
        ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), top + context.px(kReserved)));
    }

  private:
    /// Draws the buttons that step through the worst parts by the chosen measure.
    static void drawRanking(Shell &context, const Judgement &judgement) {
        const std::size_t count = judgement.worst.size();
        const std::optional<std::size_t> rank = context.probe.rank;
        ImGui::AlignTextToFramePadding();
        ui::small(context, count == 0 ? judgement.name + ": nothing to rank"
                           : rank     ? ui::format("%zu of the %zu worst: %s", *rank + 1, count, judgement.name.c_str())
                                      : ui::format("The %zu worst: %s", count, judgement.name.c_str()));
        ui::mark(context, "probe/rank");
        ui::tooltip(context, "Choose the measure in the Histogram panel");
        ImGui::SameLine(ImGui::GetContentRegionMax().x - context.px(62));
        if (ui::iconButton(context, "probe/previous", icon::kBack, "Previous", false, rank && *rank > 0, 26.0F)) {
            goToRank(context, *rank - 1);
        }
        ImGui::SameLine(0, context.px(4));
        const std::size_t next = rank ? *rank + 1 : 0;
        if (ui::iconButton(context, "probe/next", icon::kForward, rank ? "Next" : "Go to the worst", false,
                           next < count, 26.0F)) {
            goToRank(context, next);
        }
    }

    static void drawPart(Shell &context, const MeshPick &pick) {
        const std::vector<std::pair<std::string, std::string>> rows = describePart(context, pick);
        ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(context.px(3), 0));
        if (ImGui::BeginTable("part", 2, ImGuiTableFlags_SizingFixedFit)) {
            for (const auto &[label, value] : rows) {
                ImGui::TableNextColumn();
                ui::muted(context, label);
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(value.c_str());
                ui::mark(context, "probe/" + label);
                ui::tooltip(context, value);
            }
            ImGui::EndTable();
        }
        ImGui::PopStyleVar();
        drawConstraints(context, pick);
    }

    /// Draws the buttons that make the part a constraint of the drawing.
    static void drawConstraints(Shell &context, const MeshPick &pick) {
        const Judgement &judgement = *context.judgement;
        if (context.probe.chosen != pick || !judgement.edges) {
            return; // what follows the pointer cannot be clicked
        }
        const Document &document = *context.document.current();
        const std::vector<Vec2> &nodes = judgement.of.mesh->mesh.nodes;
        if (pick.part == MeshPart::Nodes) {
            if (ui::button(context, "probe/pin", "Pin this node") &&
                context.applyCommand(pinNode(document, nodes[pick.index], kConstraintTag), "Pin node")) {
                context.log.announce("The node is now an inner point; every mesh of this drawing will include it");
            }
            ui::tooltip(context, "Add the node to the drawing, so that every later mesh includes it");
        } else if (pick.part == MeshPart::Edges) {
            const MeshEdge &edge = judgement.edges->edges[pick.index];
            const bool inner = edge.elements[1] != kNoElement;
            if (ui::button(context, "probe/keep", "Keep this edge", ui::ButtonKind::Plain, inner) &&
                context.applyCommand(keepEdge(document, nodes[index(edge.a)], nodes[index(edge.b)], kConstraintTag),
                                     "Keep edge")) {
                context.log.announce("The edge is now an inner line; every mesh of this drawing will include it");
            }
            ui::tooltip(context, inner ? "Add the edge to the drawing, so that every later mesh includes it"
                                       : "The edge lies on the boundary, which every mesh follows");
        }
    }
};

} // namespace

std::unique_ptr<Panel> makeProbePanel() {
    return std::make_unique<ProbePanel>();
}

} // namespace forefront
