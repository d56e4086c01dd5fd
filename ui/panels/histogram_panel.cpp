#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/colour_map.hpp"
#include "ui/style/quality_range.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

class HistogramPanel final : public Panel {
  public:
    const char *id() const override { return "histogram"; }
    const char *title() const override { return "Histogram"; }
    PanelPlace place() const override { return PanelPlace::Tabbed; }

    void draw(Shell &context) override {
        const MeshQuality &quality = context.run.now().quality;
        if (quality.elements == 0) {
            ui::small(context, "Mesh the drawing to see how the shape factor \xce\xb1 is distributed.", true);
            ui::mark(context, "histogram/empty");
            return;
        }
        drawSummary(context, quality);
        drawRange(context, quality);
        const float axis = context.px(18);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImVec2 room = ImGui::GetContentRegionAvail();
        const float height = std::max(context.px(30), room.y - axis - context.px(2));
        drawBars(context, quality, at, {room.x, height});
        drawAxis(context, {at.x, at.y + height}, room.x);
    }

  private:
    static void drawSummary(Workspace &context, const MeshQuality &quality) {
        if (context.view.isolatedBin) {
            const int bin = *context.view.isolatedBin;
            const std::string text =
                ui::format("only \xce\xb1 %.3f\xe2\x80\x93%.3f", bin / static_cast<double>(kHistogramBins),
                           (bin + 1) / static_cast<double>(kHistogramBins));
            if (ui::badge(context, "histogram/all", text + "   " + icon::kCross, context.theme.accent)) {
                context.view.isolatedBin.reset();
            }
        } else {
            ui::small(context, ui::format("\xce\xb1  mean %.3f   geometric %.3f   min %.3f", quality.alphaMean,
                                          quality.alphaGeometricMean, quality.alphaMin));
        }
    }

    /// The ends of the colour map; they fit the mesh until the user sets them.
    static void drawRange(Workspace &context, const MeshQuality &quality) {
        const ColourRange fitted = fittedQualityRange(quality);
        ColourRange range = context.view.qualityRange.value_or(fitted);
        ImGui::AlignTextToFramePadding();
        ui::small(context, "Colours from");
        ImGui::SameLine();
        const bool from = ui::inputNumber(context, "histogram/from", range.from, 52.0F);
        ImGui::SameLine();
        ui::small(context, "to");
        ImGui::SameLine();
        const bool to = ui::inputNumber(context, "histogram/to", range.to, 52.0F);
        ImGui::SameLine();
        if (ui::button(context, "histogram/fit", "Fit", ui::ButtonKind::Plain, context.view.qualityRange.has_value())) {
            context.view.qualityRange.reset();
            context.animate();
        }
        ui::tooltip(context, "Fit the colours to the mesh");
        if ((from || to) && !(range.from < range.to && range.from >= 0.0 && range.to <= 1.0)) {
            context.log.add(Diagnostic{.severity = Severity::Warning,
                                       .code = "bad-range",
                                       .message = "colour range " + ui::number(range.from) + " to " +
                                                  ui::number(range.to) + " is not within 0 to 1",
                                       .advice = "enter two numbers in increasing order"});
        } else if (from || to) {
            context.view.qualityRange = range;
            context.animate();
        }
    }

    /// Draws bars whose height is proportional to the square root of the count, so that a few bad elements stay visible
    /// beside thousands of good ones.
    static void drawBars(Workspace &context, const MeshQuality &quality, ImVec2 at, ImVec2 size) {
        const ColourRange range = context.view.qualityRange.value_or(fittedQualityRange(quality));
        const auto &bins = quality.alphaHistogram;
        const double largest =
            std::sqrt(static_cast<double>(std::max<std::uint64_t>(1, *std::max_element(bins.begin(), bins.end()))));
        const float each = size.x / static_cast<float>(bins.size());
        ImDrawList &list = *ImGui::GetWindowDrawList();
        for (std::size_t i = 0; i < bins.size(); ++i) {
            const ImVec2 corner{at.x + each * static_cast<float>(i), at.y};
            const std::string name = "histogram/" + std::to_string(i);
            ImGui::SetCursorScreenPos(corner);
            const bool clicked = ImGui::InvisibleButton(name.c_str(), {each, size.y});
            ui::mark(context, name, bins[i] > 0);
            const bool hovered = ImGui::IsItemHovered() && bins[i] > 0;
            const bool alone = context.view.isolatedBin == static_cast<int>(i);
            if (bins[i] > 0) {
                const double middle = (static_cast<double>(i) + 0.5) / static_cast<double>(bins.size());
                const float tall = std::max(
                    context.px(2), size.y * static_cast<float>(std::sqrt(static_cast<double>(bins[i])) / largest));
                Colour colour = cividis(range.position(middle));
                if (context.theme.kind == ThemeKind::Dark && middle < 0.55) {
                    colour = mix(colour, context.theme.muted, 0.35); // the dark end of the map on a dark panel
                }
                colour = context.view.isolatedBin && !alone ? fade(colour, 0.35) : colour;
                list.AddRectFilled({corner.x + 0.5F, corner.y + size.y - tall},
                                   {corner.x + each - 0.5F, corner.y + size.y},
                                   hovered || alone ? mix(colour, context.theme.text, 0.35) : colour, context.px(1));
            }
            if (clicked && bins[i] > 0) {
                context.view.isolatedBin = alone ? std::nullopt : std::optional(static_cast<int>(i));
                context.animate();
            }
            if (hovered) {
                ui::tooltip(context, ui::format("\xce\xb1 %.3f\xe2\x80\x93%.3f: ", static_cast<double>(i) / 40.0,
                                                static_cast<double>(i + 1) / 40.0) +
                                         ui::count(bins[i]) + " elements\nClick to show only these");
            }
        }
    }

    static void drawAxis(WidgetContext &context, ImVec2 at, float width) {
        ImDrawList &list = *ImGui::GetWindowDrawList();
        list.AddLine(at, {at.x + width, at.y}, context.theme.line);
        ImGui::PushFont(context.fonts.small);
        for (int i = 0; i <= 5; ++i) {
            const std::string text = i == 0 ? "0" : i == 5 ? "1" : ui::format("0.%d", 2 * i);
            const float textWidth = ImGui::CalcTextSize(text.c_str()).x;
            const float x = at.x + width * static_cast<float>(i) / 5.0F;
            const float left = std::clamp(x - textWidth / 2, at.x, at.x + width - textWidth);
            list.AddText({left, at.y + context.px(3)}, context.theme.muted, text.c_str());
        }
        ImGui::PopFont();
    }
};

} // namespace

std::unique_ptr<Panel> makeHistogramPanel() {
    return std::make_unique<HistogramPanel>();
}

} // namespace forefront
