#include "ui/panels/unfinished_note.hpp"

#include "ui/parts/shell.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/checks_summary.hpp"

#include <imgui.h>

namespace forefront {

void drawUnfinishedNote(Shell &context, const std::string &panel) {
    const std::string text = unfinishedText(context);
    if (text.empty()) {
        return;
    }
    constexpr float kButton = 116.0F; // design pixels
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.warn);
    ImGui::TextUnformatted(icon::kWarning);
    ImGui::PopStyleColor();
    ImGui::SameLine(0, context.px(8));
    ui::wrappedText(text);
    ui::mark(context, panel + "/unfinished");
    const float room = ImGui::GetWindowContentRegionMax().x - (ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x);
    if (room > context.px(static_cast<double>(kButton) + 16.0)) {
        ImGui::SameLine(0, context.px(12));
    }
    if (ui::button(context, panel + "/finish", "Go to the end", ui::ButtonKind::Primary, true, kButton)) {
        context.run.seekEnd();
        context.animate();
    }
    ui::tooltip(context, "Finish the run, so that the whole mesh is judged");
}

} // namespace forefront
