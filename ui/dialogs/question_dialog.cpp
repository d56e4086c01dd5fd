#include "ui/dialogs/question_dialog.hpp"

#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstddef>

namespace forefront {

namespace {

constexpr float kAnswerWidth = 124.0F, kAnswerGap = 10.0F; ///< of the buttons, in design pixels

float rowWidth(std::size_t answers) {
    const auto count = static_cast<float>(answers);
    return count * kAnswerWidth + (count - 1.0F) * kAnswerGap;
}

} // namespace

float QuestionDialog::width() const {
    constexpr float kMargins = 44.0F;
    return std::max(Dialog::width(), rowWidth(answers_.size()) + kMargins);
}

bool QuestionDialog::draw(Shell &context) {
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text_.c_str());
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, context.px(10)});
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x -
                         context.px(static_cast<double>(rowWidth(answers_.size()))));
    const Answer *given = nullptr;
    for (const Answer &answer : answers_) {
        if (ui::button(context, "dialog/" + id_ + "/" + answer.id, answer.label,
                       answer.primary ? ui::ButtonKind::Primary : ui::ButtonKind::Plain, true, kAnswerWidth) ||
            (answer.primary && ui::enterPressed())) {
            given = &answer;
        }
        ImGui::SameLine(0, context.px(static_cast<double>(kAnswerGap)));
    }
    ImGui::NewLine();
    if (given != nullptr && given->then) {
        given->then(context);
    }
    return given == nullptr;
}

} // namespace forefront
