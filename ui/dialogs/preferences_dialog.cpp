#include "ui/dialogs/preferences_dialog.hpp"

#include "ui/parts/shell.hpp"
#include "ui/widgets/enum_choice.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <cmath>
#include <optional>
#include <span>

namespace forefront {
namespace {

constexpr float kLabel = 190.0F;

void note(WidgetContext &context, const char *text) {
    ImGui::SetCursorPosX(context.px(kLabel));
    ui::small(context, text, true);
    ImGui::Dummy({0, context.px(6)});
}

/// Draws a field for a number above 0 that may be empty; `zero`: 0 is allowed. Returns true if it changed.
bool optionalNumber(Shell &context, const char *name, std::optional<double> &value, const char *hint,
                    bool zero = false) {
    std::optional<double> entered = value;
    if (!ui::inputOptional(context, name, entered, hint, 120.0F) ||
        (entered && !ui::checkPositive(context, name, *entered, zero))) {
        return false;
    }
    value = entered;
    return true;
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
    note(context, "How near the pointer must be. Hold Ctrl to turn snapping off.");
    ui::rowLabel(context, "Angle step", kLabel);
    if (ui::slider(context, "dialog/preferences/snap/angle", context.snapping.angleStep, kMinAngleStep, kMaxAngleStep,
                   "%.0f\xc2\xb0")) {
        context.snapping.angleStep = std::round(context.snapping.angleStep);
    }
    note(context, "Of directions and rotations while Shift is held.");
    ui::rowLabel(context, "Grid step", kLabel);
    std::optional<double> step =
        context.snapping.gridStep > 0.0 ? std::optional(context.snapping.gridStep) : std::nullopt;
    if (optionalNumber(context, "dialog/preferences/snap/step", step, "auto")) {
        context.snapping.gridStep = step.value_or(0.0);
        context.animate();
    }
    note(context, "Distance of the grid lines in units of the drawing; auto: it follows the zoom.");
}

void drawNewDrawings(Shell &context) {
    Settings &settings = context.settings;
    ui::rowLabel(context, "Method", kLabel);
    ui::segmented(context, "dialog/preferences/new/method", settings.newMethod);
    ImGui::Dummy({0, context.px(2)});
    ui::rowLabel(context, "Improve", kLabel);
    ui::segmented(context, "dialog/preferences/new/improve", settings.newImprove);
    ImGui::Dummy({0, context.px(2)});
    ui::rowLabel(context, "Element size", kLabel);
    optionalNumber(context, "dialog/preferences/new/size", settings.newSize, "auto");
    ui::rowLabel(context, "Gradation", kLabel);
    optionalNumber(context, "dialog/preferences/new/gradation", settings.newGradation, "auto");
    ui::rowLabel(context, "Elements per turn", kLabel);
    optionalNumber(context, "dialog/preferences/new/perturn", settings.newPerTurn, "auto", true);
    ui::rowLabel(context, "Elements per gap", kLabel);
    optionalNumber(context, "dialog/preferences/new/across", settings.newAcross, "auto", true);
    note(context, "Used by File \xe2\x80\xba New. The open drawing keeps its own; see the Spacing and Meshing panels.");
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
    scale_.draw(context, "dialog/preferences/scale");
    note(context, kScaleNote);
    ui::rowLabel(context, "", kLabel);
    if (ui::button(context, "dialog/preferences/scale/reset", "100 %", ui::ButtonKind::Plain, settings.scale != 1.0)) {
        scale_.reset(context);
        context.animate();
    }
    ui::rowLabel(context, "Hints", kLabel);
    ui::checkbox(context, "dialog/preferences/hints", "Show hints on the canvas", settings.hints);
    ui::rowLabel(context, "Motion", kLabel);
    ui::checkbox(context, "dialog/preferences/reducemotion", "Reduce motion", settings.reduceMotion);
    ui::rowLabel(context, "At the start", kLabel);
    ui::checkbox(context, "dialog/preferences/reopens", "Open the last projects", settings.reopens);
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
