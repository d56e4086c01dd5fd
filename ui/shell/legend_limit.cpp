#include "ui/canvas/legend.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/judging.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace forefront::shell {

namespace {

/// The limit that the legend of the quality shows, and its bar.
struct LimitOnBar {
    MeshLimit limit = MeshLimit::MinAlpha;
    PixelRect bar;
    double at = 0.0; ///< of the tick, in [0, 1] along the bar
};

std::optional<LimitOnBar> limitOnBar(const Shell &context) {
    const WidgetRegistry::Widget *const legend = context.widgets.find("canvas/legend/quality");
    const JudgeRequest &of = context.judgement->of;
    const std::optional<MeshLimit> limit = of.fieldValues ? std::nullopt : limitOf(of.measure);
    if (legend == nullptr || !limit || context.judgement->summary.count == 0) {
        return std::nullopt;
    }
    const PixelRect &rect = legend->rect;
    const PixelRect bar =
        colourBarRect({rect.x + rect.width, rect.y + rect.height}, static_cast<double>(context.scale));
    return LimitOnBar{*limit, bar, limitPosition(of.measure, measureRange(context), measureBounds(context))};
}

/// Returns the value at a place of the bar, rounded to about a hundredth of the range.
double roundedValue(const Shell &context, double at) {
    const Measure measure = context.judgement->of.measure;
    const ColourRange range = measureRange(context);
    const double value = mapValue(measure, range, at);
    const double step = std::pow(10.0, std::floor(std::log10((range.to - range.from) / 40.0)));
    return step * std::round(value / step);
}

/// Drags the limit to the pointer, and sets it when the button is released: at the bad end of the bar, it is removed.
void drag(Shell &context, const LimitOnBar &shown) {
    const auto x = static_cast<double>(ImGui::GetIO().MousePos.x);
    const double at = std::clamp((x - shown.bar.x) / shown.bar.width, 0.0, 1.0);
    const DraggedLimit dragged{shown.limit, roundedValue(context, at)};
    context.animate();
    if (!ImGui::IsItemDeactivated()) {
        context.view.draggedLimit = dragged;
        return;
    }
    context.view.draggedLimit.reset();
    const bool removes = limitInfo(shown.limit).isMinimum ? at <= 0.0 : at >= 1.0;
    const std::optional<double> value = removes ? std::nullopt : std::optional(dragged.value);
    if (context.document.current()->limits[shown.limit] != value) {
        setLimit(context, shown.limit, value);
    }
}

} // namespace

void drawLegendLimit(Shell &context) {
    const std::optional<LimitOnBar> shown = limitOnBar(context);
    if (!shown) {
        context.view.draggedLimit.reset();
        return;
    }
    const PixelRect &bar = shown->bar;
    const float reach = context.px(7), above = context.px(8);
    const auto x = static_cast<float>(bar.x + shown->at * bar.width);
    const ImVec2 size{2.0F * reach, above + static_cast<float>(bar.height)};
    ImGui::SetNextWindowPos({x - reach, static_cast<float>(bar.y) - above});
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
    ImGui::Begin("##legendlimit", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    ui::hitArea("tick", size.x, size.y);
    ui::mark(context, "canvas/limit");
    if (ImGui::IsItemActive() || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    }
    if (ImGui::IsItemActive() || ImGui::IsItemDeactivated()) {
        drag(context, *shown);
    }
    const LimitInfo &info = limitInfo(shown->limit);
    const MeasureBounds bounds = measureBounds(context);
    const std::optional<double> bound = info.isMinimum ? bounds.minimum : bounds.maximum;
    ui::tooltip(context, std::string("Limit: ") + info.name +
                             (bound ? " " + valueText(shown->limit, *bound) : std::string(", not set")) +
                             "\nDrag it; beyond the end of the bar, it is off");
    ImGui::End();
    ImGui::PopStyleVar(2);
}

} // namespace forefront::shell
