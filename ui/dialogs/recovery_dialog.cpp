#include "ui/dialogs/recovery_dialog.hpp"

#include "ui/dialogs/recovery.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <string>

namespace forefront {

bool RecoveryDialog::draw(Shell &context) {
    ImGui::PushTextWrapPos(0.0F);
    const std::vector<Recovery::Orphan> &orphans = recovery_.orphans();
    ImGui::TextUnformatted(orphans.size() == 1
                               ? "Forefront closed unexpectedly. This unsaved drawing can be recovered:"
                               : "Forefront closed unexpectedly. Recover all unsaved drawings, each in a tab, or only "
                                 "the chosen one; the others are kept and offered again at the next start.");
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, context.px(4)});
    const float rows = static_cast<float>(std::min<std::size_t>(orphans.size(), 6));
    ImGui::BeginChild("orphans", {0, rows * context.px(32)}, false, ImGuiWindowFlags_NoNav);
    for (std::size_t k = 0; k < orphans.size(); ++k) {
        const Recovery::Orphan &orphan = orphans[k];
        if (ui::selectable(context, "dialog/recovery/item/" + std::to_string(k), orphan.name, k == chosen_,
                           orphan.details)) {
            chosen_ = k;
        }
        ui::tooltip(context, orphan.journal.savedAt().string());
    }
    ImGui::EndChild();
    ImGui::Dummy({0, context.px(8)});
    constexpr double kWidth = 112.0;
    const bool discarded = ui::button(context, "dialog/recovery/discard", "Discard", ui::ButtonKind::Plain, true,
                                      static_cast<float>(kWidth));
    ui::tooltip(context, "Delete the chosen drawing for good");
    const double buttons = orphans.size() > 1 ? 3.0 : 2.0;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - context.px(buttons * kWidth + (buttons - 1.0) * 10.0));
    const bool later = ui::button(context, "dialog/recovery/later", "Ask later", ui::ButtonKind::Plain, true,
                                  static_cast<float>(kWidth));
    ImGui::SameLine(0, context.px(10));
    const bool several = orphans.size() > 1;
    const bool recovered =
        ui::button(context, "dialog/recovery/recover", "Recover",
                   several ? ui::ButtonKind::Plain : ui::ButtonKind::Primary, true, static_cast<float>(kWidth));
    bool all = false;
    if (several) {
        ImGui::SameLine(0, context.px(10));
        all = ui::button(context, "dialog/recovery/all", "Recover all", ui::ButtonKind::Primary, true,
                         static_cast<float>(kWidth));
    }
    if (all || (several && ui::enterPressed())) {
        return !recovery_.recoverAll(context);
    }
    if (recovered || ui::enterPressed()) {
        return !recovery_.recover(chosen_, context);
    }
    if (discarded) {
        recovery_.discard(chosen_, context);
        chosen_ = 0;
    }
    return !later && !orphans.empty();
}

} // namespace forefront
