#include "ui/style/theme.hpp"

#include <imgui.h>

namespace forefront {

namespace {

Theme darkTheme() {
    Theme t;
    t.kind = ThemeKind::Dark;
    t.canvas = rgb(0x0f1215);
    t.domain = rgb(0x1a1f26);
    t.panel = rgb(0x22262d);
    t.inset = rgb(0x181b20);
    t.fieldBorder = rgb(0x727d8c);
    t.raised = rgb(0x30363f);
    t.hovered = rgb(0x3a414c);
    t.pressed = rgb(0x465060);
    t.line = rgb(0x363d47);
    t.popup = rgb(0x2a2f37);
    t.popupBorder = rgb(0x566070);
    t.selectedRow = rgb(0x253a57);
    t.dim = rgb(0x06080a, 0.35);
    t.text = rgb(0xe8ecf1);
    t.muted = rgb(0xb6bec9);
    t.placeholder = rgb(0x949eab);
    t.faint = rgb(0x7f8997);
    t.onAccent = rgb(0x08111f);
    t.accent = rgb(0x5aa2ff);
    t.good = rgb(0x4cc38a);
    t.bad = rgb(0xff6369);
    t.warn = rgb(0xffe066);
    t.boundary = rgb(0xe2e8f0);
    t.constraint = rgb(0x63e6ac);
    t.determined = rgb(0xd2e07a);
    t.selection = rgb(0x5aa2ff);
    t.mesh = rgb(0x7f8da1, 0.8);
    t.meshOnTint = rgb(0xe8ecf1, 0.65);
    t.compared = rgb(0xff5fd7);
    t.element = rgb(0x272d37);
    t.front = rgb(0xff9a3d);
    t.base = rgb(0xff3d8b);
    t.core = rgb(0xffffff);
    t.accepted = rgb(0x59d0ff);
    t.candidate = rgb(0xaeb7c3);
    t.cell = rgb(0x6f8fb8);
    t.visited = rgb(0x9b8cff);
    t.gridLine = rgb(0xffffff, 0.05);
    t.brush = rgb(0xffffff);
    return t;
}

Theme lightTheme() {
    Theme t;
    t.kind = ThemeKind::Light;
    t.canvas = rgb(0xdfe3e8);
    t.domain = rgb(0xffffff);
    t.panel = rgb(0xf7f8fa);
    t.inset = rgb(0xffffff);
    t.fieldBorder = rgb(0x7f8997);
    t.raised = rgb(0xe3e7ec);
    t.hovered = rgb(0xd6dce3);
    t.pressed = rgb(0xc6cdd7);
    t.line = rgb(0xd3d9e0);
    t.popup = rgb(0xffffff);
    t.popupBorder = rgb(0xaab3bf);
    t.selectedRow = rgb(0xd8e6fa);
    t.dim = rgb(0x1c2430, 0.35);
    t.text = rgb(0x1b222c);
    t.muted = rgb(0x4a5563);
    t.placeholder = rgb(0x626d7b);
    t.faint = rgb(0x7a8594);
    t.onAccent = rgb(0xffffff);
    t.accent = rgb(0x1a66cc);
    t.good = rgb(0x147a45);
    t.bad = rgb(0xc6263c);
    t.warn = rgb(0x8a6a00);
    t.boundary = rgb(0x1b222c);
    t.constraint = rgb(0x1a6b47);
    t.determined = rgb(0x6e7800);
    t.selection = rgb(0x1a66cc);
    t.mesh = rgb(0x6f7d90, 0.9);
    t.meshOnTint = rgb(0x1b222c, 0.6);
    t.compared = rgb(0xb0009a);
    t.element = rgb(0xeef2f7);
    t.front = rgb(0xd45d00);
    t.base = rgb(0xe0006f);
    t.core = rgb(0xffffff);
    t.accepted = rgb(0x0077b3);
    t.candidate = rgb(0x4a5563);
    t.cell = rgb(0x5d7fae);
    t.visited = rgb(0x5a48d6);
    t.gridLine = rgb(0x000000, 0.06);
    t.brush = rgb(0x1b222c);
    return t;
}

ImVec4 vector(const Colour &colour, double alpha = 1.0) {
    return ImGui::ColorConvertU32ToFloat4(fade(colour, alpha));
}

void applyColours(const Theme &t, ImVec4 *c) {
    const ImVec4 none = vector(Colour());
    c[ImGuiCol_Text] = vector(t.text);
    c[ImGuiCol_TextDisabled] = vector(t.placeholder);
    c[ImGuiCol_WindowBg] = vector(t.panel);
    c[ImGuiCol_ChildBg] = none;
    c[ImGuiCol_PopupBg] = vector(t.popup);
    c[ImGuiCol_Border] = vector(t.popupBorder);
    c[ImGuiCol_BorderShadow] = none;
    c[ImGuiCol_FrameBg] = vector(t.inset);
    c[ImGuiCol_FrameBgHovered] = vector(mix(t.inset, t.raised, 0.5));
    c[ImGuiCol_FrameBgActive] = vector(t.inset);
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = vector(t.popup);
    c[ImGuiCol_MenuBarBg] = vector(t.panel);
    c[ImGuiCol_ScrollbarBg] = none;
    c[ImGuiCol_ScrollbarGrab] = vector(t.faint, 0.35);
    c[ImGuiCol_ScrollbarGrabHovered] = vector(t.faint, 0.6);
    c[ImGuiCol_ScrollbarGrabActive] = vector(t.faint, 0.8);
    c[ImGuiCol_CheckMark] = vector(t.text);
    c[ImGuiCol_SliderGrab] = vector(t.muted);
    c[ImGuiCol_SliderGrabActive] = vector(t.text);
    c[ImGuiCol_Button] = vector(t.raised);
    c[ImGuiCol_ButtonHovered] = vector(t.hovered);
    c[ImGuiCol_ButtonActive] = vector(t.pressed);
    c[ImGuiCol_Header] = vector(t.selectedRow);
    c[ImGuiCol_HeaderHovered] = vector(t.hovered);
    c[ImGuiCol_HeaderActive] = vector(t.pressed);
    c[ImGuiCol_Separator] = vector(t.line);
    c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = vector(t.accent, 0.7);
    c[ImGuiCol_ResizeGrip] = none;
    c[ImGuiCol_ResizeGripHovered] = c[ImGuiCol_ResizeGripActive] = vector(t.accent, 0.5);
    c[ImGuiCol_Tab] = none;
    c[ImGuiCol_TabHovered] = vector(t.hovered);
    c[ImGuiCol_TabActive] = vector(t.raised);
    c[ImGuiCol_TabUnfocused] = none;
    c[ImGuiCol_TabUnfocusedActive] = vector(t.raised);
    c[ImGuiCol_TableHeaderBg] = vector(t.raised);
    c[ImGuiCol_TableBorderStrong] = c[ImGuiCol_TableBorderLight] = vector(t.line);
    c[ImGuiCol_TableRowBg] = none;
    c[ImGuiCol_TableRowBgAlt] = vector(t.raised, 0.35);
    c[ImGuiCol_TextSelectedBg] = vector(t.accent, 0.35);
    c[ImGuiCol_DragDropTarget] = vector(t.accent);
    c[ImGuiCol_NavHighlight] = vector(t.accent);
    c[ImGuiCol_ModalWindowDimBg] = vector(t.dim);
}

} // namespace

Theme makeTheme(ThemeKind kind) {
    return kind == ThemeKind::Dark ? darkTheme() : lightTheme();
}

void applyTheme(const Theme &theme, float scale) {
    ImGuiStyle style; // start from the defaults: ScaleAllSizes accumulates
    style.WindowPadding = {12, 12};
    style.FramePadding = {8, 4};
    style.CellPadding = {8, 4};
    style.ItemSpacing = {8, 4};
    style.ItemInnerSpacing = {8, 4};
    style.IndentSpacing = 16;
    style.ScrollbarSize = 10;
    style.GrabMinSize = 5; // narrow, since the number is written across it
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = 0;
    style.WindowRounding = 0;
    style.ChildRounding = 6;
    style.FrameRounding = 4;
    style.PopupRounding = 6;
    style.ScrollbarRounding = 5;
    style.GrabRounding = 4;
    style.TabRounding = 4;
    style.WindowMinSize = {8, 8};
    style.WindowTitleAlign = {0.0F, 0.5F};
    style.WindowMenuButtonPosition = ImGuiDir_None;
    style.CurveTessellationTol = 0.6F;
    style.CircleTessellationMaxError = 0.2F;
    applyColours(theme, style.Colors);
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

} // namespace forefront
