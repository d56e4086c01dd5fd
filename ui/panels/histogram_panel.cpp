#include "ui/panels/measure_choice.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/unfinished_note.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/measure_colours.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/judging.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

namespace {

/// Shows how the values of a measure are distributed, and chooses the measure.
class HistogramPanel final : public Panel {
  public:
    const char *id() const override { return "histogram"; }
    const char *title() const override { return "Histogram"; }

    void draw(Shell &context) override {
        // Hold a reference, since choosing a measure must not change what the rest of the panel draws.
        const std::shared_ptr<const Judgement> judgement = context.judgement;
        if (!judgement->of.mesh) {
            ui::small(context,
                      "Mesh the drawing, or open a mesh, to see how its angles, sizes and other measures are "
                      "distributed.",
                      true);
            ui::mark(context, "histogram/empty");
            return;
        }
        drawUnfinishedNote(context, "histogram");
        // Beside the range and the button that fits it.
        constexpr float kRange = 2.0F * 48.0F + 3.0F * 4.0F + 44.0F, kLeast = 96.0F, kMost = 170.0F; // design pixels
        const float beside = ImGui::GetContentRegionAvail().x / context.scale - kRange;
        drawMeasureChoice(context, "histogram/measure", std::clamp(beside, kLeast, kMost));
        if (judgement->summary.count == 0) {
            ui::small(context, noneText(*judgement), true);
            ui::mark(context, "histogram/none");
            return;
        }
        if (judgement->of.measure != Measure::Region) {
            ImGui::SameLine(0, context.px(6));
            drawMeasureRange(context, *judgement, "histogram");
        }
        drawSummary(context, *judgement);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImVec2 room = ImGui::GetContentRegionAvail();
        const float height = context.px(110);
        drawBars(context, *judgement, at, {room.x, height});
        drawAxis(context, judgement->histogram, {at.x, at.y + height}, room.x);
        ui::mark(context, "histogram/axis");
    }

  private:
    /// Returns why there are no values.
    static const char *noneText(const Judgement &judgement) {
        if (judgement.of.fieldValues) {
            return judgement.of.fieldPart == MeshPart::Nodes ? "The nodes have no values."
                                                             : "The elements have no values.";
        }
        return judgement.of.measure == Measure::Across
                   ? "Nothing faces across a gap."
                   : "This measure compares the mesh with the node spacing \xcf\x81, but there is none.";
    }

    static void drawSummary(Workspace &context, const Judgement &judgement) {
        const MeasureSummary &summary = judgement.summary;
        constexpr int kDigits = 3; // so that the line fits into the panel
        const auto text = [&judgement](double value) { return valueText(judgement, value, kDigits); };
        const std::optional<int> bin = context.view.isolatedBin;
        if (bin && static_cast<std::size_t>(*bin) < judgement.histogram.bins.size()) {
            const auto k = static_cast<std::size_t>(*bin);
            const std::string range = std::string("only ") + judgement.info.symbol + ' ' +
                                      ui::number(judgement.histogram.edge(k)) + "\xe2\x80\x93" +
                                      ui::number(judgement.histogram.edge(k + 1));
            if (ui::badge(context, "histogram/all", range + "   " + icon::kCross, context.theme.accent)) {
                context.view.isolatedBin.reset();
            }
            return;
        }
        ui::small(context, "min " + text(summary.minimum) + "  median " + text(summary.percentiles[3]) + "  mean " +
                               text(summary.mean) + "  max " + text(summary.maximum));
        ui::mark(context, "histogram/summary");
        std::string percentiles = judgement.name + " of " + ui::count(summary.count) + ' ' +
                                  std::string(wordOf(judgement.info.part)) + (summary.count == 1 ? "" : "s");
        for (std::size_t i = 0; i < kPercentiles.size(); ++i) {
            percentiles += ui::format("\n%d %% are below ", kPercentiles[i]) + text(summary.percentiles[i]);
        }
        ui::tooltip(context, percentiles);
    }

    /// Returns the colour of a bar, that of the value in its middle.
    static Colour barColour(const Workspace &context, const Judgement &judgement, std::size_t bin) {
        const MeasureHistogram &bins = judgement.histogram;
        const Measure measure = judgement.of.measure;
        const double from = bins.edge(bin), to = bins.edge(bin + 1);
        const double middle = bins.logarithmic ? std::sqrt(from * to) : 0.5 * (from + to);
        const Colour colour =
            measureMap(context)(std::clamp(mapPosition(measure, measureRange(context), middle), 0.0, 1.0));
        // The dark end of a map would be invisible on a dark panel.
        const bool dark = context.theme.kind == ThemeKind::Dark && colour.r + colour.g + colour.b < 240;
        return dark ? mix(colour, context.theme.muted, 0.35) : colour;
    }

    /// Draws bars whose height is proportional to the square root of the count, so that a few bad elements stay visible
    /// beside thousands of good ones.
    static void drawBars(Workspace &context, const Judgement &judgement, ImVec2 at, ImVec2 size) {
        const auto &bins = judgement.histogram.bins;
        const double largest =
            std::sqrt(static_cast<double>(std::max<std::uint64_t>(1, *std::max_element(bins.begin(), bins.end()))));
        const float each = size.x / static_cast<float>(bins.size());
        ImDrawList &list = *ImGui::GetWindowDrawList();
        for (std::size_t i = 0; i < bins.size(); ++i) {
            const ImVec2 corner{at.x + each * static_cast<float>(i), at.y};
            const std::string name = "histogram/" + std::to_string(i);
            ImGui::SetCursorScreenPos(corner);
            const bool clicked = ui::hitArea(name.c_str(), each, size.y);
            ui::mark(context, name, bins[i] > 0);
            if (bins[i] == 0) {
                continue;
            }
            const bool hovered = ImGui::IsItemHovered();
            const bool alone = context.view.isolatedBin == static_cast<int>(i);
            const float tall =
                std::max(context.px(2), size.y * static_cast<float>(std::sqrt(static_cast<double>(bins[i])) / largest));
            const Colour colour =
                fade(barColour(context, judgement, i), context.view.isolatedBin && !alone ? 0.35 : 1.0);
            const ImVec2 upper{corner.x + 0.5F, corner.y + size.y - tall},
                lower{corner.x + each - 0.5F, corner.y + size.y};
            list.AddRectFilled(upper, lower, hovered || alone ? mix(colour, context.theme.text, 0.35) : colour,
                               context.px(1));
            if (context.theme.kind == ThemeKind::Light) { // on which the colours of a good mesh are almost invisible
                list.AddRect(upper, lower, context.theme.fieldBorder, context.px(1));
            }
            if (clicked) {
                context.view.isolatedBin = alone ? std::nullopt : std::optional(static_cast<int>(i));
                context.animate();
            }
            if (hovered) {
                ui::tooltip(context, barText(judgement, i));
            }
        }
    }

    static std::string barText(const Judgement &judgement, std::size_t bin) {
        const MeasureHistogram &bins = judgement.histogram;
        const MeasureInfo &info = judgement.info;
        const std::uint64_t count = bins.bins[bin];
        return std::string(info.symbol) + ' ' + ui::number(bins.edge(bin)) + "\xe2\x80\x93" +
               ui::number(bins.edge(bin + 1)) + info.unit + ": " + ui::count(count) + ' ' +
               std::string(wordOf(info.part)) + (count == 1 ? "" : "s") + "\nClick to show only these";
    }

    static void drawAxis(WidgetContext &context, const MeasureHistogram &bins, ImVec2 at, float width) {
        ImDrawList &list = *ImGui::GetWindowDrawList();
        list.AddLine(at, {at.x + width, at.y}, context.theme.line);
        ImGui::PushFont(context.fonts.small);
        constexpr std::size_t kTicks = 5;
        for (std::size_t i = 0; i <= kTicks; ++i) {
            const double t = static_cast<double>(i) / kTicks;
            const double value =
                bins.logarithmic ? bins.from * std::pow(bins.to / bins.from, t) : bins.from + t * (bins.to - bins.from);
            const std::string text = ui::number(value, 3);
            const float textWidth = ImGui::CalcTextSize(text.c_str()).x;
            const float x = at.x + width * static_cast<float>(t);
            const float left = std::clamp(x - textWidth / 2, at.x, at.x + width - textWidth);
            list.AddText({left, at.y + context.px(3)}, context.theme.muted, text.c_str());
        }
        ImGui::SetCursorScreenPos(at);
        ImGui::Dummy({width, context.px(3) + ImGui::GetTextLineHeight()}); // the panel is as high as its content
        ImGui::PopFont();
    }
};

} // namespace

std::unique_ptr<Panel> makeHistogramPanel() {
    return std::make_unique<HistogramPanel>();
}

} // namespace forefront
