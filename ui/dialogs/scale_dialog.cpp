#include "ui/dialogs/scale_dialog.hpp"

#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

namespace forefront {

void ScaleSlider::draw(Shell &context, const std::string &name) {
    if (percent_ <= 0.0) {
        percent_ = 100.0 * context.settings.scale;
    }
    ui::slider(context, name, percent_, 75.0, 300.0, "%.0f %%");
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        context.settings.scale = percent_ / 100.0;
    }
}

void ScaleSlider::reset(Shell &context) {
    percent_ = 100.0;
    context.settings.scale = 1.0;
}

bool ScaleDialog::draw(Shell &context) {
    ui::small(context, kScaleNote, true);
    slider_.draw(context, "scale/slider");
    ImGui::Dummy({0, context.px(4)});
    if (ui::button(context, "scale/reset", "100 %")) {
        slider_.reset(context);
    }
    ImGui::SameLine(ImGui::GetContentRegionMax().x - context.px(90));
    return !ui::button(context, "scale/done", "Done", ui::ButtonKind::Primary, true, 90.0F);
}

} // namespace forefront
