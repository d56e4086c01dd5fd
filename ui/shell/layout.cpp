#include "ui/shell/shell.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace forefront::shell {

namespace {

constexpr double kMenuHeight = 34, kToolWidth = 46, kTimelineHeight = 78, kStatusHeight = 27;

} // namespace

Layout layOut(const AppContext &context) {
    const PixelSize size = context.platform.framebufferSize();
    const double width = size.width, height = size.height;
    const auto px = [&](double design) { return std::round(static_cast<double>(context.px(design))); };
    Layout layout;
    layout.menu = {0, 0, width, px(kMenuHeight)};
    const bool panels = context.view.panels;
    const double status = panels ? px(kStatusHeight) : 0.0;
    const double timeline = px(kTimelineHeight);
    layout.status = {0, height - status, width, status};
    layout.timeline = {0, height - status - timeline, width, timeline};
    const double top = layout.menu.height, middle = std::max(0.0, layout.timeline.y - top);
    const double tools = panels ? px(kToolWidth) : 0.0;
    const double column =
        panels ? std::min(px(context.settings.panelWidth), std::max(0.0, 0.6 * (width - tools))) : 0.0;
    layout.tools = {0, top, tools, middle};
    layout.column = {width - column, top, column, middle};
    layout.canvas = {tools, top, std::max(1.0, width - tools - column), std::max(1.0, middle)};
    return layout;
}

void beginRegion(const char *name, const PixelRect &rect, Colour background, float padX, float padY) {
    ImGui::SetNextWindowPos({static_cast<float>(rect.x), static_cast<float>(rect.y)});
    ImGui::SetNextWindowSize({static_cast<float>(rect.width), static_cast<float>(rect.height)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(padX, padY));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, background);
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

} // namespace forefront::shell
