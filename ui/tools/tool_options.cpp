#include "ui/tools/tool_options.hpp"

#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"
#include "ui/workspace/workspace.hpp"

#include <imgui.h>

#include <cmath>

namespace forefront {

void drawTagOption(Workspace &context, ui::Flow &flow, EditState &state, ShapeUse use, const char *tooltip) {
    flow.item("tag");
    ImGui::AlignTextToFramePadding();
    ui::muted(context, "Tag");
    ImGui::SameLine();
    std::int32_t tag = state.tagOfNext(use, *context.document.current());
    double value = tag;
    if (ui::inputNumber(context, "options/tag", value, 44.0F) && value >= 1.0 && value <= 1e9) {
        tag = static_cast<std::int32_t>(std::floor(value));
        (use == ShapeUse::Boundary ? state.boundaryTag : state.constraintTag) = tag;
    }
    ui::tooltip(context, tooltip);
    ImGui::SameLine();
    ui::muted(context, boundaryName(context.document.current()->boundaryNames, tag));
}

namespace {

bool drawNumber(Workspace &context, ui::Flow &flow, const char *name, const char *label, double &value,
                const char *tooltip, bool zero) {
    flow.item(name);
    ImGui::AlignTextToFramePadding();
    ui::muted(context, label);
    ImGui::SameLine();
    double entered = value;
    const bool changed =
        ui::inputNumber(context, name, entered, 76.0F) && ui::checkPositive(context, name, entered, zero);
    ui::tooltip(context, tooltip);
    if (changed) {
        value = entered;
    }
    return changed;
}

} // namespace

bool drawSizeOption(Workspace &context, ui::Flow &flow, const char *name, const char *label, double &value,
                    const char *tooltip) {
    return drawNumber(context, flow, name, label, value, tooltip, false);
}

bool drawOptionalSizeOption(Workspace &context, ui::Flow &flow, const char *name, const char *label,
                            std::optional<double> &value, const char *hint, const char *tooltip) {
    flow.item(name);
    ImGui::AlignTextToFramePadding();
    ui::muted(context, label);
    ImGui::SameLine();
    std::optional<double> entered = value;
    const bool changed = ui::inputOptional(context, name, entered, hint, 76.0F) &&
                         (!entered || ui::checkPositive(context, name, *entered));
    ui::tooltip(context, tooltip);
    if (changed) {
        value = entered;
    }
    return changed;
}

bool drawLengthOption(Workspace &context, ui::Flow &flow, const char *name, const char *label, double &value,
                      const char *tooltip) {
    return drawNumber(context, flow, name, label, value, tooltip, true);
}

} // namespace forefront
