#include "ui/dialogs/question_dialog.hpp"

#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

namespace forefront {

bool QuestionDialog::draw(Shell &context) {
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text_.c_str());
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, context.px(10)});
    constexpr float kWidth = 124.0F, kGap = 10.0F;
    const auto count = static_cast<float>(answers_.size());
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x -
                         context.px(static_cast<double>(count * kWidth + (count - 1.0F) * kGap)));
    const Answer *given = nullptr;
    for (const Answer &answer : answers_) {
        if (ui::button(context, "dialog/" + id_ + "/" + answer.id, answer.label,
                       answer.primary ? ui::ButtonKind::Primary : ui::ButtonKind::Plain, true, kWidth) ||
            (answer.primary && ui::enterPressed())) {
            given = &answer;
        }
        ImGui::SameLine(0, context.px(static_cast<double>(kGap)));
    }
    ImGui::NewLine();
    if (given != nullptr && given->then) {
        given->then(context);
    }
    return given == nullptr;
}

} // namespace forefront
