#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

namespace {

std::string timeText(double seconds) {
    return seconds < 1.0 ? ui::format("%.3g ms", 1e3 * seconds) : ui::format("%.3g s", seconds);
}

/// A figure of a mesh or run.
struct RunStatistic {
    const char *id;    ///< its symbol, by which lessons name it: "statistics/ID"
    const char *words; ///< the label
    std::string value;
    const char *meaning;
    const char *term = nullptr; ///< of the glossary; null: none
};

class StatisticsPanel final : public Panel {
  public:
    const char *id() const override { return "statistics"; }
    const char *title() const override { return "Statistics"; }

    void draw(Shell &context) override {
        const SessionSnapshot &run = context.run.now();
        if (run.state == RunState::Empty || run.state == RunState::Failed) {
            ui::small(context, "Mesh the drawing to see statistics of the mesh and of the run.", true);
            ui::mark(context, "statistics/empty");
            return;
        }
        ImGui::PushFont(context.fonts.small);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
        constexpr double kFigureGap = 16.0; // between the columns, in design pixels
        const std::vector<RunStatistic> all = figuresOf(run);
        const float left = ImGui::GetCursorPosX();
        const float width = std::floor((ImGui::GetContentRegionAvail().x - context.px(kFigureGap)) / 2);
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (k % 2 == 1) {
                ImGui::SameLine(left + width + context.px(kFigureGap));
            }
            drawFigure(context, all[k], width);
        }
        drawHash(context, run);
        ImGui::PopStyleVar();
        ImGui::PopFont();
    }

  private:
    static constexpr double kFigureRow = 24.0; ///< height of a row, in design pixels

    /// Draws a label and its value at the ends of a cell. The tooltip covers all of it, and a click opens the glossary.
    static void drawFigure(Shell &context, const RunStatistic &figure, float width) {
        const ImVec2 from = ImGui::GetCursorScreenPos();
        const float height = context.px(kFigureRow), y = from.y + (height - ImGui::GetFontSize()) / 2;
        const float value = ImGui::CalcTextSize(figure.value.c_str()).x;
        ImGui::Dummy({width, height});
        ImDrawList &list = *ImGui::GetWindowDrawList();
        const std::string words = ui::oneLine(figure.words, width - value - context.px(6));
        list.AddText({from.x, y}, context.theme.muted, words.c_str());
        list.AddText({from.x + width - value, y}, context.theme.text, figure.value.c_str());
        const PixelRect rect{from.x, from.y, width, height};
        ui::markPart(context, std::string("statistics/") + figure.id, rect);
        ui::tooltipOver(context, rect, figure.meaning);
        const ImVec2 to{from.x + width, from.y + height};
        if (figure.term != nullptr && ImGui::IsMouseHoveringRect(from, to, false) && ImGui::IsWindowHovered() &&
            ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
            context.actions.run(std::string("glossary.") + figure.term, context);
        }
    }

    /// Returns the figures, those of the mesh in the first of two columns, those of the run in the second one.
    static std::vector<RunStatistic> figuresOf(const SessionSnapshot &run) {
        const MeshQuality &q = run.quality;
        const WorkCounters &w = run.work;
        const auto perElement = [&w](std::uint64_t sum) {
            return w.elements == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(w.elements);
        };
        return {
            {"Nn", "Nodes Nn", ui::count(q.nodes), "Nn: nodes of the mesh", "counters"},
            {"\xce\x93", "Front \xce\x93", ui::count(run.frontSegments),
             "\xce\x93: segments on the generation front now", "front"},
            {"Ne", "Elements Ne", ui::count(q.elements), "Ne: elements of the mesh", "counters"},
            {"Nb", "Mean front Nb", ui::mean(w.frontMean()), "Nb: mean number of segments on the front", "counters"},
            {"area", "Area", ui::grouped(q.area, 6), "Total area of the elements"},
            {"Nc", "Neighbours Nc", ui::mean(w.neighboursMean()),
             "Nc: mean number of nearby segments that the background grid returns per element", "counters"},
            {"\xce\xb1 mean", "Mean \xce\xb1", ui::format("%.4f", q.alphaMean),
             "Shape factor \xce\xb1 = 4\xe2\x88\x9a"
             "3\xc2\xb7"
             "area/\xce\xa3l\xc2\xb2, arithmetic mean; 1: equilateral",
             "shape-factor"},
            {"Ns", "Considered Ns", ui::mean(w.consideredMean()),
             "Ns: mean number of segments near enough to be considered per element, for each candidate side",
             "counters"},
            {"\xce\xb1 geom.", "Geometric \xce\xb1", ui::format("%.4f", q.alphaGeometricMean),
             "Geometric mean of the shape factor \xce\xb1", "shape-factor"},
            {"Nt", "Exact tests Nt", ui::mean(w.testsMean()), "Nt: mean number of exact intersection tests per element",
             "counters"},
            {"\xce\xb1 min", "Worst \xce\xb1", ui::format("%.4f", q.alphaMin),
             "Shape factor \xce\xb1 of the worst element", "shape-factor"},
            {"cells", "Grid cells", ui::mean(perElement(w.cellsVisited)),
             "Mean number of cells of the background grid visited per element", "grid"},
            {"\xce\xb4 mean", "Mean \xce\xb4", ui::format("%.4f", q.deltaMean),
             "Spacing conformity \xce\xb4 = min(L/\xcf\x81, \xcf\x81/L), mean over the segments", "conformity"},
            {"candidates", "Candidates", ui::mean(perElement(w.candidates)),
             "Mean number of candidate nodes considered per element", "candidates"},
            {"min \xe2\x88\xa0", "Smallest angle", ui::format("%.1f\xc2\xb0", q.minAngle),
             "Smallest angle of all elements"},
            {"new nodes", "New nodes", ui::count(w.newNodes), "Advances that created a node"},
            {"max \xe2\x88\xa0", "Largest angle", ui::format("%.1f\xc2\xb0", q.maxAngle),
             "Largest angle of all elements"},
            {"deferred", "Deferred", ui::count(w.deferrals),
             "Advances that created no element: the base segment was deferred", "deferral"},
            {"time", "Front time", timeText(run.secondsMesh), "CPU time spent advancing the front"},
            {"forced", "Forced", ui::count(w.forced), "Elements made from existing nodes only, to close the front",
             "closing"},
            {"improve", "Improving", timeText(run.secondsImprove), "CPU time spent swapping edges and smoothing",
             "improvement"}};
    }

    /// Draws the hash, which is too long for a cell, in a row of its own.
    static void drawHash(Shell &context, const SessionSnapshot &run) {
        const RunStatistic hash{"hash", "Hash",
                                run.meshHash != 0 && run.atEnd()
                                    ? ui::format("%016llx", static_cast<unsigned long long>(run.meshHash))
                                    : std::string("\xe2\x80\x93"),
                                "Two meshes are identical bit for bit if and only if their hashes are equal"};
        drawFigure(context, hash, ImGui::GetContentRegionAvail().x);
    }
};

} // namespace

std::unique_ptr<Panel> makeStatisticsPanel() {
    return std::make_unique<StatisticsPanel>();
}

} // namespace forefront
