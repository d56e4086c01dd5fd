#include "ui/shell/run_plot.hpp"

#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace forefront::shell {

namespace {

using Sample = RunCurves::Sample;

/// A curve with its own scale, see rangeOf().
struct PlotCurve {
    const char *name, *tip;
    float Sample::*value;
    Colour colour;
    bool unit; ///< its values lie in [0, 1]
};

std::array<PlotCurve, 4> curvesOf(const Theme &theme) {
    return {{{"segments of \xce\x93", "Number of segments on the front, mean over the advances of a point of the curve",
              &Sample::front, theme.front, false},
             {"tests per element", "Mean number of exact intersection tests per element, over the advances of a point",
              &Sample::tests, theme.visited, false},
             {"mean \xce\xb1", "Mean shape factor of the elements made in the advances of a point", &Sample::alphaMean,
              theme.good, true},
             {"minimum \xce\xb1",
              "Shape factor of the worst element made in the advances of a point; the Statistics panel has that of the "
              "mesh",
              &Sample::alphaMin, fade(theme.bad, 0.75), true}}};
}

/// The rectangle of the curves, in pixels.
struct Frame {
    TimeAxis axis;
    float top, bottom;
};

/// The range of values between the lower and the upper edge.
struct Range {
    float from, to;
};

/// Returns 0 to the maximum, or for α the tenths around all of its values, since most of them are close to 1.
Range rangeOf(const RunCurves &curves, const PlotCurve &curve) {
    Range range{curve.unit ? 1.0F : 0.0F, curve.unit ? 1.0F : 1e-6F};
    for (const Sample &sample : curves.samples) {
        if (curve.unit) {
            range.from = std::min(range.from, std::floor(10.0F * sample.alphaMin - 1.0F) / 10.0F);
        } else {
            range.to = std::max(range.to, sample.*curve.value);
        }
    }
    return range;
}

void drawCurve(WidgetContext &context, const SessionSnapshot &run, const PlotCurve &curve, const Frame &frame) {
    const RunCurves &curves = *run.curves;
    const Range range = rangeOf(curves, curve);
    const float scale = (frame.bottom - frame.top) / std::max(range.to - range.from, 1e-6F);
    std::vector<ImVec2> points;
    points.reserve(curves.samples.size());
    for (std::size_t i = 0; i < curves.samples.size(); ++i) {
        const double from = static_cast<double>(i * curves.advancesPerSample);
        const double to =
            std::min(static_cast<double>(run.known), from + static_cast<double>(curves.advancesPerSample));
        const float height = scale * (curves.samples[i].*curve.value - range.from);
        points.push_back({frame.axis.x(0.5 * (from + to)), frame.bottom - height});
    }
    ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), curve.colour, 0,
                                            context.px(1.25));
}

std::string valueText(float value, bool unit) {
    return unit ? ui::format("%.3f", static_cast<double>(value)) : ui::mean(static_cast<double>(value));
}

/// Draws the names left of the curves, each with its value at an advance.
void drawNames(WidgetContext &context, const Sample &sample, float top, float right) {
    ImDrawList &list = *ImGui::GetWindowDrawList();
    ImGui::PushFont(context.fonts.small);
    float y = top + context.px(2);
    const auto curves = curvesOf(context.theme);
    for (const PlotCurve &curve : curves) {
        const std::string value = valueText(sample.*curve.value, curve.unit);
        list.AddRectFilled({context.px(14), y + context.px(5)}, {context.px(26), y + context.px(7)}, curve.colour);
        list.AddText({context.px(32), y}, context.theme.muted, curve.name);
        list.AddText({right - ImGui::CalcTextSize(value.c_str()).x, y}, context.theme.text, value.c_str());
        const PixelRect rect{static_cast<double>(context.px(14)), static_cast<double>(y),
                             static_cast<double>(right - context.px(14)), static_cast<double>(context.px(17))};
        ui::tooltipOver(context, rect, curve.tip);
        y += context.px(19);
    }
    ImGui::PopFont();
}

} // namespace

void drawRunPlot(Shell &context, const TimeAxis &axis, float top) {
    const SessionSnapshot &run = context.run.now();
    const Frame frame{axis, top + context.px(6), top + context.px(kPlotHeight) - context.px(10)};
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({axis.left, frame.top - context.px(2)}, {axis.right, frame.bottom + context.px(2)},
                       fade(context.theme.canvas, 0.6), context.px(3));
    ui::markRect(context, "timeline/plot",
                 {static_cast<double>(axis.left), static_cast<double>(frame.top),
                  static_cast<double>(axis.right - axis.left), static_cast<double>(frame.bottom - frame.top)},
                 run.known > 0);
    if (run.known == 0 || !run.curves || run.curves->samples.empty()) {
        ImGui::SetCursorScreenPos({context.px(14), top + context.px(8)});
        ui::small(context, "Mesh the drawing or step through it to see plots of the run here.");
        return;
    }
    ImGui::SetCursorScreenPos({axis.left, frame.top});
    ui::hitArea("##plot", axis.right - axis.left, frame.bottom - frame.top);
    const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
    list.PushClipRect({axis.left, frame.top - context.px(2)}, {axis.right, frame.bottom + context.px(2)}, true);
    for (const PlotCurve &curve : curvesOf(context.theme)) {
        drawCurve(context, run, curve, frame);
    }
    const float here = axis.x(static_cast<double>(run.position()));
    list.AddLine({here, frame.top}, {here, frame.bottom}, context.theme.accent, context.px(1.5));
    std::uint64_t shown = run.position();
    if (active || hovered) {
        shown = axis.positionAt(ImGui::GetIO().MousePos.x);
        const float x = axis.x(static_cast<double>(shown));
        list.AddLine({x, frame.top}, {x, frame.bottom}, context.theme.muted, 1.0F);
    }
    list.PopClipRect();
    if (active && shown != run.position()) {
        context.run.seek(shown);
    } else if (hovered) {
        ui::tooltip(context, positionName(run, shown));
    }
    const std::size_t last = run.curves->samples.size() - 1;
    const auto index = static_cast<std::size_t>(shown / run.curves->advancesPerSample);
    Sample sample = run.curves->samples[std::min(index, last)];
    if (run.complete && shown >= run.known) {
        sample.front = 0.0F; // the front is empty now, whatever its mean over the last advances
    }
    drawNames(context, sample, top, axis.left - context.px(14));
}

} // namespace forefront::shell
