#include "core/drawing/names/region_commands.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/unfinished_note.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/judging.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace forefront {

namespace {

constexpr float kRankRow = 24.0F; ///< height of a row, design pixels

/// A column of the table; its text ends at `end` design pixels from the left edge, or begins there.
struct RankColumn {
    double end;
    bool right;
};
constexpr std::array<RankColumn, 6> kRankColumns{
    {{32.0, true}, {112.0, true}, {212.0, true}, {312.0, true}, {412.0, true}, {436.0, false}}};
using RankTexts = std::array<std::string, kRankColumns.size()>;

std::string capital(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') {
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    }
    return text;
}

/// Returns the name or number of the region of a part; of an edge, that of its first element; of a node, nothing.
std::string regionText(const Judgement &judgement, MeshPart part, std::uint32_t number) {
    std::size_t element = number;
    if (part == MeshPart::Nodes) {
        return {};
    }
    if (part == MeshPart::Edges) {
        element = index(judgement.edges->edges[number].elements[0]);
    }
    const MeshView mesh = judgement.of.mesh->view();
    return regionName(mesh.regionNames, mesh.region(static_cast<std::uint32_t>(element)));
}

/// Lists the worst parts by the measure that is shown. A click, or the arrow keys, go to them.
class WorstPanel final : public Panel {
  public:
    const char *id() const override { return "worst"; }
    const char *title() const override { return "Worst places"; }
    PanelPlace place() const override { return PanelPlace::Below; }

    void draw(Shell &context) override {
        // Hold a reference, since a click must not change what the rest of the panel draws.
        const std::shared_ptr<const Judgement> judgement = context.judgement;
        context.probe.walks = false;
        const bool measured =
            judgement->of.mesh && (judgement->info.part != MeshPart::Edges || judgement->edges != nullptr);
        if (!measured || judgement->worst.empty()) {
            ui::small(context, judgement->of.mesh ? judgement->name + " has no order from bad to good"
                                                  : "Mesh the drawing, or open a mesh, to list its worst places.");
            ui::mark(context, "worst/empty");
            return;
        }
        drawUnfinishedNote(context, "worst");
        ImGui::PushFont(context.fonts.small);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
        drawTitles(context, *judgement);
        drawRows(context, *judgement);
        ImGui::PopStyleVar();
        ImGui::PopFont();
    }

    std::vector<ContextGroup> menu(Shell &context) override {
        const Judgement &judgement = *context.judgement;
        ContextGroup group = actionsOf({"run.worst"});
        if (!judgement.worst.empty()) {
            group.push_back(copyCommand("worst/copy", "Copy table", tableText(judgement)));
        }
        return {std::move(group)};
    }

  private:
    static RankTexts rowOf(const Judgement &judgement, std::size_t rank) {
        const std::uint32_t number = judgement.worst[rank];
        const MeshPart part = judgement.info.part;
        const Vec2 at = placeOf(judgement, part, number);
        return {std::to_string(rank + 1), std::to_string(number),   valueText(judgement, judgement.values[number], 4),
                ui::format("%.7g", at.x), ui::format("%.7g", at.y), regionText(judgement, part, number)};
    }

    static RankTexts titlesOf(const Judgement &judgement) {
        return {"No.", capital(std::string(wordOf(judgement.info.part))), capital(judgement.name), "x", "y", "Region"};
    }

    static std::string tableText(const Judgement &judgement) {
        std::string text;
        const auto add = [&text](const RankTexts &row) {
            for (std::size_t k = 0; k < row.size(); ++k) {
                text += row[k] + (k + 1 < row.size() ? '\t' : '\n');
            }
        };
        add(titlesOf(judgement));
        for (std::size_t rank = 0; rank < judgement.worst.size(); ++rank) {
            add(rowOf(judgement, rank));
        }
        return text;
    }

    static void drawTexts(const Shell &context, ImVec2 at, const RankTexts &texts, Colour colour) {
        ImDrawList &list = *ImGui::GetWindowDrawList();
        const float y = std::round(at.y + 0.5F * (context.px(kRankRow) - ImGui::GetFontSize()));
        for (std::size_t k = 0; k < texts.size(); ++k) {
            const float end = at.x + context.px(kRankColumns[k].end);
            const float width = kRankColumns[k].right ? ImGui::CalcTextSize(texts[k].c_str()).x : 0.0F;
            list.AddText({end - width, y}, colour, texts[k].c_str());
        }
    }

    static void drawTitles(const Shell &context, const Judgement &judgement) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        drawTexts(context, at, titlesOf(judgement), context.theme.muted);
        ImGui::Dummy({1.0F, context.px(kRankRow)});
    }

    void drawRows(Shell &context, const Judgement &judgement) {
        ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, context.px(24)); // a long list has a short knob
        ImGui::BeginChild("worst", {0, 0}, false, ImGuiWindowFlags_NoNav);
        context.probe.walks = ImGui::IsWindowFocused();
        const float height = context.px(kRankRow);
        if (measure_ != judgement.of.measure) {
            measure_ = judgement.of.measure;
            ImGui::SetScrollY(0.0F);
        }
        follow(context, height);
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(judgement.worst.size()), height);
        while (clipper.Step()) {
            for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
                drawRow(context, judgement, static_cast<std::size_t>(row));
            }
        }
        ImGui::EndChild();
        ImGui::PopStyleVar();
        ui::mark(context, "worst/rows");
    }

    /// Scrolls to the chosen row once it has changed.
    void follow(const Shell &context, float height) {
        const std::size_t number = context.probe.chosen && context.probe.rank ? *context.probe.rank + 1 : 0;
        if (number > 0 && number != shown_) {
            const float below = static_cast<float>(number) * height, room = ImGui::GetWindowHeight();
            ImGui::SetScrollY(std::clamp(ImGui::GetScrollY(), below - room, std::max(below - room, below - height)));
        }
        shown_ = number;
    }

    static void drawRow(Shell &context, const Judgement &judgement, std::size_t rank) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x, height = context.px(kRankRow);
        const std::string name = "worst/" + std::to_string(rank);
        const bool pressed = ui::hitArea(name.c_str(), width, height);
        ui::mark(context, name);
        const bool chosen = context.probe.chosen && context.probe.rank == rank, hovered = ImGui::IsItemHovered();
        if (chosen || hovered) {
            ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + width, at.y + height},
                                                      chosen ? context.theme.selectedRow : context.theme.hovered,
                                                      context.px(4));
        }
        drawTexts(context, at, rowOf(judgement, rank), context.theme.text);
        if (pressed) {
            goToRank(context, rank);
            context.animate();
        }
    }

    std::optional<Measure> measure_; ///< that was listed last
    std::size_t shown_ = 0;          ///< number of the row that the list was last scrolled to; 0: none
};

} // namespace

std::unique_ptr<Panel> makeWorstPanel() {
    return std::make_unique<WorstPanel>();
}

} // namespace forefront
