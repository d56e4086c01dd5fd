#include "ui/panels/panels.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

namespace forefront {

namespace {

std::string timeText(double seconds) {
    return seconds < 1.0 ? ui::format("%.3g ms", 1e3 * seconds) : ui::format("%.3g s", seconds);
}

class StatisticsPanel final : public Panel {
  public:
    const char *id() const override { return "statistics"; }
    const char *title() const override { return "Statistics"; }
    PanelPlace place() const override { return PanelPlace::Tabbed; }

    void draw(AppContext &context) override {
        const SessionSnapshot &run = context.run().now();
        if (run.state == RunState::Empty || run.state == RunState::Failed) {
            ui::small(context, "Numbers of the mesh and of the work behind it appear here.", true);
            ui::mark(context, "statistics/empty");
            return;
        }
        ImGui::PushFont(context.fonts.small);
        if (ImGui::BeginTable("numbers", 4, ImGuiTableFlags_SizingStretchProp)) {
            ImGui::TableSetupColumn("a", ImGuiTableColumnFlags_WidthStretch, 1.1F);
            ImGui::TableSetupColumn("b", ImGuiTableColumnFlags_WidthStretch, 1.0F);
            ImGui::TableSetupColumn("c", ImGuiTableColumnFlags_WidthStretch, 1.1F);
            ImGui::TableSetupColumn("d", ImGuiTableColumnFlags_WidthStretch, 0.9F);
            rows(context, run);
            ImGui::EndTable();
        }
        ImGui::PopFont();
    }

  private:
    static void cell(AppContext &context, const char *label, const std::string &value, const char *meaning) {
        ImGui::TableNextColumn();
        ui::muted(context, label);
        ui::tooltip(context, meaning);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(value.c_str());
    }

    static void rows(AppContext &context, const SessionSnapshot &run) {
        const MeshQuality &q = run.quality;
        const WorkCounters &w = run.work;
        cell(context, "Nn", ui::count(q.nodes), "Nodes");
        cell(context, "\xce\xb1 mean", ui::format("%.4f", q.alphaMean),
             "Shape factor \xce\xb1 = 4\xe2\x88\x9a"
             "3\xc2\xb7"
             "area/\xce\xa3l\xc2\xb2, arithmetic mean; 1: equilateral");
        cell(context, "Ne", ui::count(q.elements), "Elements");
        cell(context, "\xce\xb1 geom.", ui::format("%.4f", q.alphaGeometricMean), "Geometric mean of \xce\xb1");
        cell(context, "\xce\x93", ui::count(run.frontSegments), "Segments of the generation front now");
        cell(context, "\xce\xb1 least", ui::format("%.4f", q.alphaMin), "The worst element");
        cell(context, "Nb", ui::format("%.1f", w.frontMean()), "Mean length of the front");
        cell(context, "\xce\xb4 mean", ui::format("%.4f", q.deltaMean),
             "Spacing conformity min(L/\xcf\x81, \xcf\x81/L), mean over the segments");
        cell(context, "Nc", ui::format("%.2f", w.neighboursMean()),
             "Mean neighbouring segments that the background grid delivers per element");
        cell(context, "min \xe2\x88\xa0", ui::format("%.1f\xc2\xb0", q.minAngle), "Least angle");
        cell(context, "Ns", ui::format("%.3f", w.testsMean()), "Mean segments tested exactly per element");
        cell(context, "max \xe2\x88\xa0", ui::format("%.1f\xc2\xb0", q.maxAngle), "Greatest angle");
        const auto perElement = [&w](std::uint64_t sum) {
            return w.elements == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(w.elements);
        };
        cell(context, "cells", ui::format("%.2f", perElement(w.cellsVisited)),
             "Cells of the background grid visited per element");
        cell(context, "candidates", ui::format("%.2f", perElement(w.candidates)),
             "Candidate nodes considered per element");
        cell(context, "new nodes", ui::count(w.newNodes), "Advances that made a node");
        cell(context, "deferred", ui::count(w.deferrals), "Advances without an element: the base was put back");
        cell(context, "time", timeText(run.secondsMesh), "Advancing the front, processor time");
        cell(context, "forced", ui::count(w.forced), "Elements made by the closing stage, from existing nodes only");
        cell(context, "improve", timeText(run.secondsImprove), "Swapping and smoothing, processor time");
        cell(context, "hash",
             run.meshHash != 0 ? ui::format("%08x\xe2\x80\xa6", static_cast<unsigned>(run.meshHash >> 32))
                               : std::string("\xe2\x80\x93"),
             "Equal exactly when the mesh is equal bit for bit");
    }
};

} // namespace

std::unique_ptr<Panel> makeStatisticsPanel() {
    return std::make_unique<StatisticsPanel>();
}

} // namespace forefront
