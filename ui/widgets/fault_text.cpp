#include "ui/widgets/fault_text.hpp"

#include "ui/widgets/text_wrap.hpp"

#include <imgui.h>

namespace forefront::ui {

void faultText(WidgetContext &context, std::string_view text) {
    ImGui::PushFont(context.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.bad);
    wrappedText(text);
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

} // namespace forefront::ui
