#include "ui/dialogs/preferences_dialog.hpp"

#include "ui/parts/shell.hpp"
#include "ui/widgets/enum_choice.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <cmath>
#include <span>

namespace forefront {
namespace {

constexpr float kLabel = 190.0F;

void note(WidgetContext &context, const char *text) {
    ImGui::SetCursorPosX(context.px(kLabel));
    ui::small(context, text, true);
    ImGui::Dummy({0, context.px(6)});
}

void drawMeshing(Shell &context) {
    Settings &settings = context.settings;
    ui::rowLabel(context, "Live meshing", kLabel);
    ui::checkbox(context, "dialog/preferences/live", "Mesh after every change", settings.live);
    note(context, "Remesh while you move nodes or sources, or paint.");
    ui::rowLabel(context, "Live budget", kLabel);
    double budget = settings.liveBudget;
    if (ui::slider(context, "dialog/preferences/budget", budget, kMinLiveBudget, kMaxLiveBudget, "%.0f triangles",
                   true)) {
        const double unit = std::pow(10.0, std::floor(std::log10(budget)) - 1.0);
        settings.liveBudget = std::round(budget / unit) * unit;
    }
    note(context, "Larger meshes show a coarser preview while you draw; the full mesh follows when you release the "
                  "button. Lower this if the pointer stutters.");
}

void drawSnapping(Shell &context) {
    ui::rowLabel(context, "Snap to", kLabel);
    ui::checkbox(context, "dialog/preferences/snap/drawing", "Nodes and segments", context.snapping.toDrawing);
    ImGui::SetCursorPosX(context.px(kLabel));
    ui::checkbox(context, "dialog/preferences/snap/grid", "Grid", context.snapping.toGrid);
    ImGui::Dummy({0, context.px(6)});
    ui::rowLabel(context, "Distance", kLabel);
    ui::slider(context, "dialog/preferences/snap/reach", context.snapping.reach, kMinSnapReach, kMaxSnapReach,
               "%.0f pixels");
    note(context, "Hold Ctrl to turn snapping off, Shift for steps of 15\xc2\xb0.");
}

void drawNewDrawings(Shell &context) {
    Settings &settings = context.settings;
    ui::rowLabel(context, "Method", kLabel);
    ui::segmented(context, "dialog/preferences/new/method", settings.newMethod);
    ImGui::Dummy({0, context.px(2)});
    ui::rowLabel(context, "Improve", kLabel);
    ui::segmented(context, "dialog/preferences/new/improve", settings.newImprove);
    note(context, "Used by File \xe2\x80\xba New. The open drawing keeps its own options; see the Meshing panel.");
}

} // namespace

void PreferencesDialog::drawAppearance(Shell &context) {
    Settings &settings = context.settings;
    ui::rowLabel(context, "Theme", kLabel);
    static constexpr const char *kThemes[] = {"Dark", "Light"};
    int theme = settings.theme == ThemeKind::Light ? 1 : 0;
    if (ui::segmented(context, "dialog/preferences/theme", std::span(kThemes), theme, 200.0F)) {
        settings.theme = theme == 1 ? ThemeKind::Light : ThemeKind::Dark;
        context.animate();
    }
    ImGui::Dummy({0, context.px(6)});
    ui::rowLabel(context, "Interface scale", kLabel);
    if (percent_ <= 0.0) {
        percent_ = 100.0 * settings.scale;
    }
    ui::slider(context, "dialog/preferences/scale", percent_, 75.0, 300.0, "%.0f %%");
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        settings.scale = percent_ / 100.0;
    }
    note(context, "Multiplies the scale of the screen. Takes effect when you release the slider.");
    ui::rowLabel(context, "Hints", kLabel);
    ui::checkbox(context, "dialog/preferences/hints", "Show hints on the canvas", settings.hints);
    ui::rowLabel(context, "Rulers", kLabel);
    if (ui::checkbox(context, "dialog/preferences/rulers", "Show rulers along the canvas", settings.rulers)) {
        context.animate();
    }
}

bool PreferencesDialog::draw(Shell &context) {
    static constexpr const char *kPages[] = {"Appearance", "Live meshing", "Snapping", "New drawings", "Keys"};
    ui::segmented(context, "dialog/preferences/page", std::span(kPages), page_);
    ImGui::Dummy({0, context.px(10)});
    switch (page_) {
    case 0:
        drawAppearance(context);
        break;
    case 1:
        drawMeshing(context);
        break;
    case 2:
        drawSnapping(context);
        break;
    case 3:
        drawNewDrawings(context);
        break;
    default:
        keys_.draw(context);
    }
    return true;
}

} // namespace forefront
