#include "ui/widgets/tooltip.hpp"

#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace forefront::ui {

PixelRect placeTooltip(const PixelRect &widget, const PixelRect &window, Pixel size, PixelSize display, double x,
                       double gap) {
    const double width = display.width, height = display.height;
    const auto within = [](double at, double extent, double room) {
        return std::clamp(at, 0.0, std::max(0.0, room - extent));
    };
    const double level = within(widget.y, size.y, height);
    const double left = window.x - gap - size.x, right = window.x + window.width + gap;
    const bool fitsLeft = left >= 0.0, fitsRight = right + size.x <= width;
    if (window.height > 0.3 * height && (fitsLeft || fitsRight)) { // a column: beside it, towards the canvas
        const bool takesLeft = fitsLeft && (!fitsRight || window.centre().x > 0.5 * width);
        return {takesLeft ? left : right, level, size.x, size.y};
    }
    const double at = within(std::clamp(x, widget.x, widget.x + widget.width), size.x, width);
    const bool bar = window.height <= 0.3 * height;
    const PixelRect &clear = bar ? window : widget;
    const double above = clear.y - gap - size.y, below = clear.y + clear.height + gap;
    const bool fitsAbove = above >= 0.0, fitsBelow = below + size.y <= height;
    const bool takesAbove = fitsAbove && (!bar || !fitsBelow || window.centre().y > 0.5 * height);
    return {at, takesAbove ? above : within(below, size.y, height), size.x, size.y};
}

namespace {

constexpr double kWrap = 320.0, kPadX = 9.0, kPadY = 6.0; ///< design pixels

/// Returns the position of a tooltip beside `widget`, a rectangle within the current window.
PixelRect placeOf(WidgetContext &context, std::string_view text, const PixelRect &widget) {
    const ImGuiContext &imgui = *ImGui::GetCurrentContext();
    const float wrap = context.px(kWrap);
    const std::string lines = wrapped(text, wrap);
    const ImVec2 words = ImGui::CalcTextSize(lines.c_str(), nullptr, false, wrap + 1.0F);
    const ImVec2 pad(context.px(kPadX), context.px(kPadY));
    const ImGuiWindow &window = *imgui.CurrentWindow->RootWindow;
    return placeTooltip(widget, {window.Pos.x, window.Pos.y, window.Size.x, window.Size.y},
                        {std::ceil(words.x) + 2.0 * pad.x, std::ceil(words.y) + 2.0 * pad.y},
                        context.platform.framebufferSize(), imgui.IO.MousePos.x, context.px(6));
}

/// Shows a tooltip beside `widget`, a rectangle within the current window, unless there is one in this frame.
void show(WidgetContext &context, std::string_view text, const PixelRect &widget) {
    const ImGuiWindow *const shown = ImGui::FindWindowByName("##Tooltip_00");
    if (shown != nullptr && shown->Active) {
        return;
    }
    const float wrap = context.px(kWrap);
    const ImVec2 pad(context.px(kPadX), context.px(kPadY));
    const PixelRect place = placeOf(context, text, widget);
    const WidgetRegistry::Widget *const note = context.widgets.find("fieldnote");
    const WidgetRegistry::Widget *const faulty = context.widgets.find("fieldnote/field");
    if (note != nullptr && (note->rect.overlaps(place) || (faulty != nullptr && faulty->rect.overlaps(widget)))) {
        return; // what is wrong with a field matters more than what it means
    }
    ImGui::SetNextWindowPos({static_cast<float>(place.x), static_cast<float>(place.y)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, pad);
    ImGui::BeginTooltip();
    wrappedText(text, wrap);
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
    markRect(context, "tooltip", place);
}

PixelRect rectOf(ImVec2 min, ImVec2 max) {
    return {min.x, min.y, max.x - min.x, max.y - min.y};
}

} // namespace

void tooltip(WidgetContext &context, std::string_view text) {
    constexpr float kDelay = 0.4F; // seconds; none while the pointer only passes over
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        return;
    }
    const ImGuiContext &imgui = *ImGui::GetCurrentContext();
    if (imgui.HoveredId != 0 && imgui.HoveredIdTimer < kDelay) {
        context.wakeAt(context.platform.now() + static_cast<double>(kDelay - imgui.HoveredIdTimer));
        return;
    }
    if (imgui.HoveredId != 0 && imgui.HoveredIdTimer - imgui.IO.DeltaTime < kDelay) {
        context.animate(); // it appears now: Dear ImGui measures it in a frame that does not show it
    }
    show(context, text, rectOf(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()));
}

PixelRect placeFaultNote(const PixelRect &field, const PixelRect &window, Pixel size, PixelSize display, double gap) {
    const double left = std::clamp(window.x + gap, 0.0, std::max(0.0, display.width - size.x));
    const double x = std::max(left, std::min(field.x, field.x + field.width - size.x)); // their right edges in line
    const double below = field.y + field.height + gap, above = field.y - gap - size.y;
    return {x, below + size.y <= display.height || above < 0.0 ? below : above, size.x, size.y};
}

void faultNote(WidgetContext &context, std::string_view text, bool fault) {
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    const ImGuiWindow &window = *ImGui::GetCurrentContext()->CurrentWindow->RootWindow;
    const float margin = context.px(6);
    const float wrap = std::min(context.px(kWrap), window.Size.x - 2.0F * (context.px(kPadX) + margin));
    const std::string lines = wrapped(text, wrap);
    const ImVec2 words = ImGui::CalcTextSize(lines.c_str());
    const Pixel size{std::ceil(words.x) + 2.0 * context.px(kPadX), std::ceil(words.y) + 2.0 * context.px(kPadY)};
    const PixelRect place = placeFaultNote(
        rectOf(min, max), rectOf(window.Pos, {window.Pos.x + window.Size.x, window.Pos.y + window.Size.y}), size,
        context.platform.framebufferSize(), context.px(4));
    const ImVec2 from{static_cast<float>(place.x), static_cast<float>(place.y)};
    const ImVec2 to{static_cast<float>(place.x + place.width), static_cast<float>(place.y + place.height)};
    ImDrawList &list = *ImGui::GetForegroundDrawList();
    const Colour edge = fault ? context.theme.bad : context.theme.muted;
    list.AddRect(min, max, edge, context.px(4), 0, context.px(1.5));
    list.AddRectFilled(from, to, context.theme.panel, context.px(4));
    list.AddRect(from, to, edge, context.px(4));
    list.AddText({from.x + context.px(kPadX), from.y + context.px(kPadY)}, edge, lines.c_str());
    markRect(context, "fieldnote", place);
    markRect(context, "fieldnote/field", rectOf(min, max));
}

void tooltipOver(WidgetContext &context, const PixelRect &rect, std::string_view text) {
    const ImVec2 min{static_cast<float>(rect.x), static_cast<float>(rect.y)};
    const ImVec2 max{static_cast<float>(rect.x + rect.width), static_cast<float>(rect.y + rect.height)};
    if (!text.empty() && ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(min, max, false)) {
        show(context, text, rect);
    }
}

void rowTooltip(WidgetContext &context, std::string_view text) {
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        tooltip(context, text);
    } else {
        const float left = ImGui::GetCurrentWindowRead()->WorkRect.Min.x;
        tooltipOver(context, rectOf({left, min.y}, {min.x, max.y}), text);
    }
}

} // namespace forefront::ui
