#include "ui/widgets/widgets.hpp"

#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/field_frame.hpp"
#include "ui/widgets/shortened.hpp"
#include "ui/widgets/text_wrap.hpp"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

namespace forefront::ui {

namespace {

/// Scope that pushes the widget's name as Dear ImGui's id.
struct Id {
    explicit Id(std::string_view name) { ImGui::PushID(name.data(), name.data() + name.size()); }
    ~Id() { ImGui::PopID(); }
    Id(const Id &) = delete;
    Id &operator=(const Id &) = delete;
};

/// Scope of a widget that may be disabled. Its colours say so; fading them as well would make its text illegible.
struct Disabled {
    explicit Disabled(bool disabled) : disabled_(disabled) {
        if (disabled_) {
            ImGui::PushStyleVar(ImGuiStyleVar_DisabledAlpha, 1.0F);
            ImGui::BeginDisabled();
        }
    }
    ~Disabled() {
        if (disabled_) {
            ImGui::EndDisabled();
            ImGui::PopStyleVar();
        }
    }
    Disabled(const Disabled &) = delete;
    Disabled &operator=(const Disabled &) = delete;

  private:
    bool disabled_;
};

float widthOf(const WidgetContext &context, float width) {
    return width < 0.0F ? -1.0F : context.px(width);
}

/// Returns the visible part of the window; within a table, not only that of the column.
PixelRect clipOfWindow() {
    const ImRect &clip = ImGui::GetCurrentWindowRead()->InnerClipRect;
    return {clip.Min.x, clip.Min.y, clip.GetWidth(), clip.GetHeight()};
}

/// Scrolls the window, and those around it, as little as possible to show a part of it, if its widget is to be
/// revealed.
void revealPart(WidgetContext &context, std::string_view name, const ImVec2 &min, const ImVec2 &max) {
    if (context.widgets.revealed.contains(name)) {
        const float margin = context.px(6); // for an outline
        ImGui::ScrollToRect(ImGui::GetCurrentWindow(), {{min.x, min.y - margin}, {max.x, max.y + margin}},
                            ImGuiScrollFlags_KeepVisibleEdgeY);
    }
}

void pushButtonColours(const Theme &theme, ButtonKind kind, bool on, bool enabled) {
    Colour rest = theme.raised, hover = theme.hovered, press = theme.pressed, text = theme.text;
    if (!enabled) {
        rest = hover = press = kind == ButtonKind::Quiet ? Colour() : theme.raised;
        text = theme.faint;
    } else if (kind == ButtonKind::Primary) {
        rest = theme.accent;
        hover = mix(theme.accent, theme.text, 0.15);
        press = mix(theme.accent, theme.text, 0.3);
        text = theme.onAccent;
    } else if (kind == ButtonKind::Quiet) {
        rest = on ? theme.pressed : Colour();
    }
    ImGui::PushStyleColor(ImGuiCol_Button, rest);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, hover);
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, press);
    ImGui::PushStyleColor(ImGuiCol_Text, text);
}

} // namespace

bool hitArea(const char *name, float width, float height) {
    return ImGui::InvisibleButton(name, {std::max(width, 1.0F), std::max(height, 1.0F)});
}

void markRect(WidgetContext &context, std::string_view name, const PixelRect &rect, bool enabled) {
    context.widgets.add(name, {rect, enabled, true});
}

void mark(WidgetContext &context, std::string_view name, bool enabled) {
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    const PixelRect rect{min.x, min.y, max.x - min.x, max.y - min.y};
    context.widgets.add(name, {rect, enabled, ImGui::IsItemVisible(), clipOfWindow()});
    revealPart(context, name, min, max);
}

void markPart(WidgetContext &context, std::string_view name, const PixelRect &rect) {
    const PixelRect clip = clipOfWindow();
    context.widgets.add(name, {rect, true, rect.overlaps(clip), clip});
    const ImVec2 min{static_cast<float>(rect.x), static_cast<float>(rect.y)};
    revealPart(context, name, min, {min.x + static_cast<float>(rect.width), min.y + static_cast<float>(rect.height)});
}

void markWindow(WidgetContext &context, std::string_view name) {
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const PixelRect rect{at.x, at.y, size.x, size.y};
    const WidgetRegistry::Widget *const before = context.widgets.find(name);
    if (before == nullptr || !(before->rect == rect)) {
        context.animate(); // its neighbours may move
    }
    markRect(context, name, rect);
}

bool button(WidgetContext &context, std::string_view name, std::string_view label, ButtonKind kind, bool enabled,
            float width) {
    const Id id(name);
    const Disabled disabled(!enabled);
    pushButtonColours(context.theme, kind, false, enabled);
    const bool pressed = ImGui::Button(std::string(label).c_str(), {widthOf(context, width), 0.0F});
    ImGui::PopStyleColor(4);
    mark(context, name, enabled);
    return pressed;
}

bool iconButton(WidgetContext &context, std::string_view name, const char *icon, const std::string &tip, bool on,
                bool enabled, float size) {
    bool pressed = false;
    {
        const Id id(name);
        const Disabled disabled(!enabled);
        pushButtonColours(context.theme, ButtonKind::Quiet, on, enabled);
        ImGui::PushFont(size < 30.0F ? context.fonts.body : context.fonts.icons);
        const bool quiet = size < 30.0F && !on;
        ImGui::PushStyleColor(ImGuiCol_Text, !enabled ? context.theme.faint
                                             : quiet  ? context.theme.muted
                                                      : context.theme.text);
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
        pressed = ImGui::Button(icon, {context.px(size), context.px(size)});
        ImGui::PopStyleVar();
        ImGui::PopFont();
        ImGui::PopStyleColor(5);
        mark(context, name, enabled);
    }
    tooltip(context, tip);
    return pressed;
}

bool checkbox(WidgetContext &context, std::string_view name, std::string_view label, bool &value) {
    const Id id(name);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 text = ImGui::CalcTextSize(label.data(), label.data() + label.size());
    const float height = ImGui::GetFrameHeight(), box = context.px(16), gap = context.px(7);
    const bool clicked = hitArea("check", box + gap + text.x, height);
    const bool hovered = ImGui::IsItemHovered();
    mark(context, name);
    const bool focused = takesFocus(context, name);
    const bool pressed = clicked || (focused && imgui::keyPressed(key::kSpace, false));
    if (pressed) {
        value = !value;
    }
    const Theme &theme = context.theme;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const ImVec2 corner{at.x, std::round(at.y + (height - box) / 2)};
    const Colour rest = value ? theme.text : theme.inset,
                 lit = value ? mix(theme.text, theme.panel, 0.15) : theme.hovered;
    list.AddRectFilled(corner, {corner.x + box, corner.y + box}, hovered ? lit : rest, context.px(4));
    if (value) {
        const ImVec2 points[] = {{corner.x + 0.24F * box, corner.y + 0.52F * box},
                                 {corner.x + 0.43F * box, corner.y + 0.70F * box},
                                 {corner.x + 0.77F * box, corner.y + 0.31F * box}};
        list.AddPolyline(points, 3, theme.panel, 0, context.px(1.8));
    } else {
        list.AddRect(corner, {corner.x + box, corner.y + box}, theme.fieldBorder, context.px(4));
    }
    if (focused) {
        const float out = context.px(3);
        list.AddRect({corner.x - out, corner.y - out}, {corner.x + box + out, corner.y + box + out}, theme.accent,
                     context.px(6), 0, context.px(1.5));
    }
    list.AddText({at.x + box + gap, at.y + (height - text.y) / 2}, theme.text, label.data(),
                 label.data() + label.size());
    return pressed;
}

bool eyeSwitch(WidgetContext &context, std::string_view name, std::string_view label, bool &value, float width) {
    const Id id(name);
    const float height = context.px(24);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = hitArea("eye", context.px(width), height);
    if (pressed) {
        value = !value;
    }
    mark(context, name);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    if (ImGui::IsItemHovered()) {
        list.AddRectFilled(at, {at.x + context.px(width), at.y + height}, context.theme.raised, context.px(5));
    }
    const Colour colour = value ? context.theme.text : context.theme.faint;
    const float middle = at.y + (height - ImGui::GetFontSize()) / 2;
    list.AddText({at.x + context.px(3), middle}, value ? context.theme.muted : context.theme.faint,
                 value ? icon::kEye : icon::kEyeClosed);
    list.AddText({at.x + context.px(24), middle}, colour, label.data(), label.data() + label.size());
    return pressed;
}

namespace {

/// Returns the widths of the segments of a switch: equal ones, or the same room around all texts where one is longer.
std::vector<float> segmentWidths(const WidgetContext &context, std::span<const char *const> labels, float whole) {
    const auto count = static_cast<float>(labels.size());
    std::vector<float> texts;
    float longest = 0.0F, sum = 0.0F;
    for (const char *const label : labels) {
        texts.push_back(ImGui::CalcTextSize(label).x);
        longest = std::max(longest, texts.back());
        sum += texts.back();
    }
    const bool equal = longest + context.px(8) <= whole / count;
    for (float &text : texts) {
        text = equal ? whole / count : text + (whole - sum) / count;
    }
    return texts;
}

} // namespace

bool segmented(WidgetContext &context, std::string_view name, std::span<const char *const> labels, int &choice,
               float width, std::span<const char *const> tips) {
    const Id id(name);
    const float whole = width > 0.0F ? context.px(width) : ImGui::GetContentRegionAvail().x;
    const std::vector<float> widths = segmentWidths(context, labels, whole);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = context.px(24);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + whole, at.y + height}, context.theme.inset, context.px(6));
    bool changed = false;
    float left = at.x;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const float each = widths[i];
        const ImVec2 corner{left, at.y};
        left += each;
        ImGui::SetCursorScreenPos(corner);
        const bool here = choice == static_cast<int>(i);
        if (hitArea(labels[i], each, height) && !here) {
            choice = static_cast<int>(i);
            changed = true;
        }
        mark(context, std::string(name) + "/" + labels[i]);
        tooltip(context, i < tips.size() ? tips[i] : "");
        const float inset = context.px(2);
        if (here) {
            list.AddRectFilled({corner.x + inset, corner.y + inset},
                               {corner.x + each - inset, corner.y + height - inset}, context.theme.pressed,
                               context.px(5));
        }
        const ImVec2 size = ImGui::CalcTextSize(labels[i]);
        list.AddText({corner.x + (each - size.x) / 2, corner.y + (height - size.y) / 2},
                     here ? context.theme.text : context.theme.muted, labels[i]);
    }
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy({whole, height}); // so that SameLine() goes on beside it
    return changed;
}

bool combo(WidgetContext &context, std::string_view name, std::span<const char *const> labels, int &choice,
           float width) {
    const Id id(name);
    ImGui::SetNextItemWidth(widthOf(context, width));
    std::optional<FieldFrame> frame(std::in_place, context);
    const std::string chosen =
        choice >= 0 && choice < static_cast<int>(labels.size()) ? labels[static_cast<std::size_t>(choice)] : "";
    const float room = ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - 2.0F * ImGui::GetStyle().FramePadding.x;
    const std::string shown = withoutMiddle(chosen, room);
    bool changed = false;
    const bool open = ImGui::BeginCombo("##combo", shown.c_str(), ImGuiComboFlags_HeightLarge);
    frame.reset();
    mark(context, name);
    if (!open && shown != chosen) {
        tooltip(context, chosen);
    }
    if (open) {
        for (std::size_t i = 0; i < labels.size(); ++i) {
            ImGui::PushID(static_cast<int>(i)); // labels may be empty or repeated
            if (ImGui::Selectable(labels[i], choice == static_cast<int>(i))) {
                choice = static_cast<int>(i);
                changed = true;
            }
            ImGui::PopID();
            mark(context, std::string(name) + "/" + labels[i]);
        }
        ImGui::EndCombo();
    }
    return changed;
}

bool combo(WidgetContext &context, std::string_view name, const std::vector<std::string> &labels, int &choice,
           float width) {
    std::vector<const char *> texts;
    texts.reserve(labels.size());
    for (const std::string &label : labels) {
        texts.push_back(label.c_str());
    }
    return combo(context, name, std::span<const char *const>(texts), choice, width);
}

bool slider(WidgetContext &context, std::string_view name, double &value, double minimum, double maximum,
            const char *pattern, bool logarithmic, float width) {
    const Id id(name);
    // The number stands beside the slider: in it, the knob would cover it.
    const float beside = std::max(ImGui::CalcTextSize(format(pattern, minimum).c_str()).x,
                                  ImGui::CalcTextSize(format(pattern, maximum).c_str()).x) +
                         context.px(8);
    const float whole = width < 0.0F ? ImGui::GetContentRegionAvail().x : context.px(width);
    ImGui::BeginGroup();
    ImGui::SetNextItemWidth(std::max(whole - beside, context.px(24)));
    const bool typing = ImGui::TempInputIsActive(ImGui::GetID("##slider")); // after a click with Ctrl
    ImGui::PushStyleColor(ImGuiCol_Text, typing ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : ImVec4(0, 0, 0, 0));
    std::optional<FieldFrame> frame(std::in_place, context);
    const bool changed =
        ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &minimum, &maximum, pattern,
                            ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0));
    frame.reset();
    ImGui::PopStyleColor();
    mark(context, name);
    ImGui::SameLine(0, context.px(8));
    ImGui::TextUnformatted(format(pattern, value).c_str());
    mark(context, std::string(name) + "/number");
    ImGui::EndGroup();
    return changed;
}

bool thinSlider(WidgetContext &context, std::string_view name, double &t, std::string_view shown, float width,
                float textWidth) {
    const Id id(name);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = context.px(26), whole = context.px(static_cast<double>(width));
    hitArea("thin", whole, height);
    mark(context, name);
    // The last move and the release may arrive in the same frame.
    const bool active = ImGui::IsItemActive() || ImGui::IsItemDeactivated(), hovered = ImGui::IsItemHovered();
    const float inset = context.px(6), middle = at.y + height / 2, half = context.px(2);
    const float left = at.x + inset, right = at.x + whole - inset;
    bool changed = false;
    if (active) {
        const double wanted =
            std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - left) / (right - left)), 0.0, 1.0);
        changed = wanted != t;
        t = wanted;
    }
    const float x = left + static_cast<float>(std::clamp(t, 0.0, 1.0)) * (right - left);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({left, middle - half}, {right, middle + half}, context.theme.pressed, half);
    list.AddRectFilled({left, middle - half}, {x, middle + half}, context.theme.muted, half);
    list.AddCircleFilled({x, middle}, context.px(active || hovered ? 6.5 : 5.5), context.theme.text, 20);
    ImGui::SameLine(0, 0);
    const ImVec2 size = ImGui::CalcTextSize(shown.data(), shown.data() + shown.size());
    const ImVec2 text = ImGui::GetCursorScreenPos();
    list.AddText({text.x + context.px(4), text.y + (height - size.y) / 2}, context.theme.muted, shown.data(),
                 shown.data() + shown.size());
    ImGui::Dummy({context.px(static_cast<double>(textWidth)), height});
    return changed;
}

bool selectable(WidgetContext &context, std::string_view name, std::string_view label, bool selected,
                std::string_view detail) {
    const Id id(name);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = context.px(28);
    const bool pressed = ImGui::Selectable("##row", selected, ImGuiSelectableFlags_None, {width, height});
    mark(context, name);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const float y = at.y + (height - ImGui::GetFontSize()) / 2;
    float right = at.x + width - context.px(8);
    if (!detail.empty()) {
        const ImVec2 size = ImGui::CalcTextSize(detail.data(), detail.data() + detail.size());
        right -= size.x;
        list.AddText({right, y}, context.theme.muted, detail.data(), detail.data() + detail.size());
        right -= context.px(8);
    }
    const float left = at.x + context.px(8);
    if (left + ImGui::CalcTextSize(label.data(), label.data() + label.size()).x > right) {
        tooltip(context, label);
    }
    shortened(context, {left, y}, right, label, context.theme.text);
    return pressed;
}

bool link(WidgetContext &context, std::string_view name, std::string_view text) {
    const Id id(name);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
    const bool pressed = hitArea("link", size.x, size.y);
    const bool hovered = ImGui::IsItemHovered();
    mark(context, name);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddText(at, context.theme.accent, text.data(), text.data() + text.size());
    if (hovered) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        list.AddLine({at.x, at.y + size.y}, {at.x + size.x, at.y + size.y}, context.theme.accent);
    }
    return pressed;
}

void heading(WidgetContext &context, std::string_view text) {
    ImGui::PushFont(context.fonts.heading);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopFont();
}

void markCaption(WidgetContext &context, std::string_view text) {
    mark(context, "caption/" + std::string(text) + '/' + std::to_string(std::lround(ImGui::GetItemRectMin().y)));
}

namespace {

/// Goes to the column of the fields: beside the label just drawn, or below one that leaves no gap.
void toColumn(const WidgetContext &context, double width) {
    constexpr double kGap = 6.0; // design pixels
    const float column = context.px(width);
    if (ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + ImGui::GetScrollX() + context.px(kGap) > column) {
        ImGui::SetCursorPosX(column);
    } else {
        ImGui::SameLine(column);
    }
}

} // namespace

void field(WidgetContext &context, std::string_view label, std::string_view value, double width) {
    muted(context, label);
    markCaption(context, label);
    toColumn(context, width);
    ImGui::TextUnformatted(value.data(), value.data() + value.size());
}

void muted(WidgetContext &context, std::string_view text) {
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.muted);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
}

void rowLabel(WidgetContext &context, const char *text, double width) {
    ImGui::AlignTextToFramePadding();
    muted(context, text);
    markCaption(context, text);
    toColumn(context, width);
}

void small(WidgetContext &context, std::string_view text, bool wrap) {
    ImGui::PushFont(context.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.muted);
    if (wrap) {
        wrappedText(text);
    } else {
        ImGui::TextUnformatted(text.data(), text.data() + text.size());
    }
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

bool badge(WidgetContext &context, std::string_view name, std::string_view text, Colour colour) {
    const Id id(name);
    ImGui::PushFont(context.fonts.small);
    const ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 box{size.x + context.px(18), size.y + context.px(8)};
    const bool pressed = hitArea("badge", box.x, box.y);
    const bool hovered = ImGui::IsItemHovered();
    mark(context, name);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + box.x, at.y + box.y}, fade(colour, hovered ? 0.35 : 0.2), box.y / 2);
    list.AddRect(at, {at.x + box.x, at.y + box.y}, colour, box.y / 2); // the text is not in the colour: it is too near
    list.AddText({at.x + context.px(9), at.y + context.px(4)}, context.theme.text, text.data(),
                 text.data() + text.size());
    ImGui::PopFont();
    return pressed;
}

} // namespace forefront::ui
