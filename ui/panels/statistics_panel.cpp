#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <string>
#include <string_view>
#include <utility>

namespace forefront {

namespace {

std::string timeText(double seconds) {
    return seconds < 1.0 ? ui::format("%.3g ms", 1e3 * seconds) : ui::format("%.3g s", seconds);
}

/// Returns the glossary term that explains a figure, or null.
const char *termOf(std::string_view label) {
    constexpr std::pair<std::string_view, const char *> kTerms[] = {
        {"Nn", "counters"},    {"Ne", "counters"},        {"Nb", "counters"},           {"Nc", "counters"},
        {"Ns", "counters"},    {"Nt", "counters"},        {"\xce\xb1", "shape-factor"}, {"\xce\xb4", "conformity"},
        {"\xce\x93", "front"}, {"cells", "grid"},         {"candidates", "candidates"}, {"deferred", "deferral"},
        {"forced", "closing"}, {"improve", "improvement"}};
    for (const auto &[start, term] : kTerms) {
        if (label.starts_with(start)) {
            return term;
        }
    }
    return nullptr;
}

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
        if (ImGui::BeginTable("numbers", 4, ImGuiTableFlags_SizingStretchProp)) {
            ImGui::TableSetupColumn("a", ImGuiTableColumnFlags_WidthStretch, 1.1F);
            ImGui::TableSetupColumn("b", ImGuiTableColumnFlags_WidthStretch, 1.0F);
            ImGui::TableSetupColumn("c", ImGuiTableColumnFlags_WidthStretch, 1.1F);
            ImGui::TableSetupColumn("d", ImGuiTableColumnFlags_WidthStretch, 0.9F);
            rows(context, run);
            ImGui::TableSetColumnIndex(1); // of the last row
            const float column = ImGui::GetCursorPosX();
            ImGui::EndTable();
            hashRow(context, run, column);
        }
        ImGui::PopFont();
    }

  private:
    /// Draws a label and its value in two columns of the table; the tooltip covers both, and a click opens the
    /// glossary.
    static void cell(Shell &context, const char *label, const std::string &value, const char *meaning) {
        ImGui::TableNextColumn();
        const ImVec2 from = ImGui::GetCursorScreenPos();
        ui::muted(context, label);
        ImGui::TableNextColumn();
        const double right = static_cast<double>(ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x);
        ImGui::TextUnformatted(value.c_str());
        const PixelRect rect{from.x, from.y, right - static_cast<double>(from.x), ImGui::GetTextLineHeight()};
        ui::markPart(context, std::string("statistics/") + label, rect);
        ui::tooltipOver(context, rect, meaning);
        const char *const term = termOf(label);
        const ImVec2 to{static_cast<float>(right), from.y + ImGui::GetTextLineHeight()};
        if (term != nullptr && ImGui::IsMouseHoveringRect(from, to, false) && ImGui::IsWindowHovered() &&
            ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
            context.actions.run(std::string("glossary.") + term, context);
        }
    }

    static void rows(Shell &context, const SessionSnapshot &run) {
        const MeshQuality &q = run.quality;
        const WorkCounters &w = run.work;
        cell(context, "Nn", ui::count(q.nodes), "Nodes");
        cell(context, "\xce\xb1 mean", ui::format("%.4f", q.alphaMean),
             "Shape factor \xce\xb1 = 4\xe2\x88\x9a"
             "3\xc2\xb7"
             "area/\xce\xa3l\xc2\xb2, arithmetic mean; 1: equilateral");
        cell(context, "Ne", ui::count(q.elements), "Elements");
        cell(context, "\xce\xb1 geom.", ui::format("%.4f", q.alphaGeometricMean), "Geometric mean of \xce\xb1");
        cell(context, "area", ui::grouped(q.area, 6), "Total area of the elements");
        cell(context, "\xce\xb1 min", ui::format("%.4f", q.alphaMin), "Shape factor of the worst element");
        cell(context, "\xce\x93", ui::count(run.frontSegments), "Segments on the generation front now");
        cell(context, "\xce\xb4 mean", ui::format("%.4f", q.deltaMean),
             "Spacing conformity min(L/\xcf\x81, \xcf\x81/L), mean over the segments");
        cell(context, "Nb", ui::mean(w.frontMean()), "Mean number of segments on the front");
        cell(context, "min \xe2\x88\xa0", ui::format("%.1f\xc2\xb0", q.minAngle), "Smallest angle");
        cell(context, "Nc", ui::mean(w.neighboursMean()),
             "Mean number of nearby segments that the background grid returns per element");
        cell(context, "max \xe2\x88\xa0", ui::format("%.1f\xc2\xb0", q.maxAngle), "Largest angle");
        cell(context, "Ns", ui::mean(w.consideredMean()),
             "Mean number of segments near enough to be considered per element, for each candidate side");
        cell(context, "Nt", ui::mean(w.testsMean()), "Mean number of exact intersection tests per element");
        const auto perElement = [&w](std::uint64_t sum) {
            return w.elements == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(w.elements);
        };
        cell(context, "cells", ui::mean(perElement(w.cellsVisited)),
             "Mean number of cells of the background grid visited per element");
        cell(context, "candidates", ui::mean(perElement(w.candidates)),
             "Mean number of candidate nodes considered per element");
        cell(context, "new nodes", ui::count(w.newNodes), "Advances that created a node");
        cell(context, "deferred", ui::count(w.deferrals),
             "Advances that created no element: the base segment was deferred");
        cell(context, "time", timeText(run.secondsMesh), "CPU time spent advancing the front");
        cell(context, "forced", ui::count(w.forced), "Elements made from existing nodes only, to close the front");
        cell(context, "improve", timeText(run.secondsImprove), "CPU time spent swapping edges and smoothing");
    }

    /// Draws the hash, which is too long for a column, in a row of its own with its value below the other ones.
    static void hashRow(Shell &context, const SessionSnapshot &run, float column) {
        const ImVec2 from = ImGui::GetCursorScreenPos();
        const double right = static_cast<double>(from.x + ImGui::GetContentRegionAvail().x);
        ui::muted(context, "hash");
        ImGui::SameLine(column);
        ImGui::TextUnformatted(run.meshHash != 0 && run.atEnd()
                                   ? ui::format("%016llx", static_cast<unsigned long long>(run.meshHash)).c_str()
                                   : "\xe2\x80\x93");
        const PixelRect rect{from.x, from.y, right - static_cast<double>(from.x), ImGui::GetTextLineHeight()};
        ui::markPart(context, "statistics/hash", rect);
        ui::tooltipOver(context, rect, "Two meshes are identical bit for bit if and only if their hashes are equal");
    }
};

} // namespace

std::unique_ptr<Panel> makeStatisticsPanel() {
    return std::make_unique<StatisticsPanel>();
}

} // namespace forefront
