#include "ui/style/theme.hpp"

#include <imgui.h>

namespace forefront {

namespace {

Theme darkTheme() {
    Theme t;
    t.kind = ThemeKind::Dark;
    t.canvas = rgb(0x12151a);
    t.domain = rgb(0x1d222a);
    t.panel = rgb(0x1a1e24);
    t.raised = rgb(0x272d36);
    t.hovered = rgb(0x323a46);
    t.pressed = rgb(0x3c4655);
    t.line = rgb(0x2b313b);
    t.popup = rgb(0x21262e);
    t.dim = rgb(0x06080a, 0.55);
    t.text = rgb(0xe4e8ee);
    t.muted = rgb(0xb4bdca);
    t.faint = rgb(0x8b96a6);
    t.onAccent = rgb(0x0b1420);
    t.accent = rgb(0x6aa9ff);
    t.good = rgb(0x54c98b);
    t.bad = rgb(0xff6b7a);
    t.warn = rgb(0xf5bd4f);
    t.boundary = rgb(0xdde4ee);
    t.constraint = rgb(0x8ad4ff);
    t.selection = rgb(0x6aa9ff);
    t.mesh = rgb(0x93a1b5, 0.85);
    t.element = rgb(0x2a313c);
    t.front = rgb(0xff9a3d);
    t.base = rgb(0xff4fa3);
    t.compared = rgb(0xff5fd7);
    t.candidate = rgb(0xffe08a);
    t.cell = rgb(0x6f8fb8);
    t.visited = rgb(0x9b8cff);
    t.gridLine = rgb(0xffffff, 0.05);
    t.brush = rgb(0xffffff);
    return t;
}

Theme lightTheme() {
    Theme t;
    t.kind = ThemeKind::Light;
    t.canvas = rgb(0xe9ecf0);
    t.domain = rgb(0xfcfdfe);
    t.panel = rgb(0xf6f7f9);
    t.raised = rgb(0xe6e9ee);
    t.hovered = rgb(0xd9dee6);
    t.pressed = rgb(0xcad2dd);
    t.line = rgb(0xd3d8e0);
    t.popup = rgb(0xffffff);
    t.dim = rgb(0x1c2430, 0.35);
    t.text = rgb(0x1b222c);
    t.muted = rgb(0x46505f);
    t.faint = rgb(0x5f6b7b);
    t.onAccent = rgb(0xffffff);
    t.accent = rgb(0x1f6fd6);
    t.good = rgb(0x16834d);
    t.bad = rgb(0xc72c41);
    t.warn = rgb(0x9a6200);
    t.boundary = rgb(0x1e2733);
    t.constraint = rgb(0x0f6ea8);
    t.selection = rgb(0x1f6fd6);
    t.mesh = rgb(0x4b596c, 0.8);
    t.element = rgb(0xeef2f7);
    t.front = rgb(0xe06500);
    t.base = rgb(0xd0127a);
    t.compared = rgb(0xb0009a);
    t.candidate = rgb(0x8a6500);
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
    c[ImGuiCol_TextDisabled] = vector(t.faint);
    c[ImGuiCol_WindowBg] = vector(t.panel);
    c[ImGuiCol_ChildBg] = none;
    c[ImGuiCol_PopupBg] = vector(t.popup);
    c[ImGuiCol_Border] = vector(t.line);
    c[ImGuiCol_BorderShadow] = none;
    c[ImGuiCol_FrameBg] = vector(t.raised);
    c[ImGuiCol_FrameBgHovered] = vector(t.hovered);
    c[ImGuiCol_FrameBgActive] = vector(t.hovered);
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = vector(t.popup);
    c[ImGuiCol_MenuBarBg] = vector(t.panel);
    c[ImGuiCol_ScrollbarBg] = none;
    c[ImGuiCol_ScrollbarGrab] = vector(t.faint, 0.35);
    c[ImGuiCol_ScrollbarGrabHovered] = vector(t.faint, 0.6);
    c[ImGuiCol_ScrollbarGrabActive] = vector(t.faint, 0.8);
    c[ImGuiCol_CheckMark] = vector(t.accent);
    c[ImGuiCol_SliderGrab] = vector(t.accent, 0.85);
    c[ImGuiCol_SliderGrabActive] = vector(t.accent);
    c[ImGuiCol_Button] = vector(t.raised);
    c[ImGuiCol_ButtonHovered] = vector(t.hovered);
    c[ImGuiCol_ButtonActive] = vector(t.pressed);
    c[ImGuiCol_Header] = vector(t.accent, 0.18);
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
    style.WindowPadding = {12, 10};
    style.FramePadding = {9, 5};
    style.CellPadding = {6, 3};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {6, 5};
    style.IndentSpacing = 16;
    style.ScrollbarSize = 10;
    style.GrabMinSize = 5; // narrow, since the number is written across it
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = 0;
    style.WindowRounding = 0;
    style.ChildRounding = 6;
    style.FrameRounding = 5;
    style.PopupRounding = 7;
    style.ScrollbarRounding = 5;
    style.GrabRounding = 5;
    style.TabRounding = 5;
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
