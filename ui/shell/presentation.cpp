#include "ui/shell/presentation.hpp"

#include "core/teaching/moment/moment.hpp"
#include "core/teaching/moment/short_texts.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/shortened.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/view/step_text.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace forefront::shell {

namespace {

/// The ten steps as a program; the second names the base by the rules of the run.
constexpr std::array<const char *, kStepCount> kProgram{
    "\xce\x93 := segments of the boundary",
    "AB := a segment of \xce\x93",
    "\xcf\x81 := spacing at AB",
    "C := ideal point on the left of AB",
    "candidates := C, nodes of \xce\x93 near it",
    "score each by shape and spacing",
    "sort them; drop C if too near \xce\x93",
    "take the first that crosses no segment",
    "store ABC; \xce\x93 := \xce\x93 \xe2\x88\x92 AB + AC + CB",
    "until \xce\x93 = \xe2\x88\x85",
};

/// Draws a line of the program in a row of a height, with its value below.
void drawLine(Shell &context, Step step, const std::string &line, const std::string &value, bool here, float height) {
    const bool inLoop = step != Step::BoundaryToFront && step != Step::Finish;
    const Theme &theme = context.theme;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    ImGui::Dummy({width, height});
    ui::mark(context, "presentation/" + std::to_string(static_cast<int>(step)));
    if (here) {
        list.AddRectFilled(at, {at.x + width, at.y + height}, theme.selectedRow, context.px(4));
        list.AddRectFilled(at, {at.x + context.px(3), at.y + height}, theme.accent, context.px(2));
    }
    const std::string number = std::to_string(static_cast<int>(step));
    const float line1 = at.y + 0.5F * (height - 2.0F * ImGui::GetTextLineHeight()),
                line2 = line1 + ImGui::GetTextLineHeight();
    const float left = at.x + context.px(inLoop ? 48 : 34), right = at.x + width - context.px(6);
    list.AddText({at.x + context.px(28) - ImGui::CalcTextSize(number.c_str()).x, line1}, theme.muted, number.c_str());
    if (inLoop) { // the body of the loop
        list.AddLine({at.x + context.px(37), at.y}, {at.x + context.px(37), at.y + height}, theme.line,
                     context.px(1.5));
    }
    ui::shortened(context, Pixel(left, line1), right, line, here ? theme.text : theme.muted);
    ui::shortened(context, Pixel(left, line2), right, value, inLoop ? theme.accent : theme.muted);
}

} // namespace

std::string presentedLine(Step step, const FrontRules *rules, bool quads) {
    if (quads) {
        return squareStepLine(step);
    }
    if (step == Step::TakeBase && rules != nullptr) {
        return "AB := " + std::string(wordOf(rules->base)) + " segment of \xce\x93";
    }
    return kProgram[static_cast<std::size_t>(step) - 1];
}

void togglePresentation(Shell &context) {
    if (context.presentedFrom) {
        if (!context.lessons.open) {
            chooseWorkspace(context, *context.presentedFrom);
        }
        context.presentedFrom.reset();
    } else {
        context.presentedFrom = context.settings.workspace;
        if (!context.lessons.open) {
            chooseWorkspace(context, WorkspaceKind::Step);
        }
    }
    context.animate();
}

void drawPresentedSteps(Shell &context, const PixelRect &rect) {
    if (rect.width < 1.0 || rect.height < 1.0) {
        return;
    }
    beginRegion("##presentation", rect, context.theme.panel, context.px(10), context.px(8));
    ui::heading(context, "The ten steps");
    ImGui::SameLine(ImGui::GetContentRegionMax().x - context.px(24));
    const bool leave =
        ui::iconButton(context, "presentation/leave", icon::kCross, "Leave the presentation (Esc)", false, true, 22.0F);
    const bool idle = !context.run.busy() && !context.adaptation.busy() && !context.task.busy(); // else Esc cancels
    const bool escapes = idle && !context.dialogs.any() && imgui::keyPressed(key::kEscape, false);
    const SessionSnapshot &run = context.run.now();
    const Moment moment = momentOf(run);
    const std::optional<Step> live = liveStep(run, moment);
    const FrontRules rules = moment ? moment.advance->rules : context.document.current()->options.rules;
    const bool quads = context.run.showsQuads();
    const FrontRules *const shown = context.run.method() == Method::Classic && !quads ? &rules : nullptr;
    const float room = ImGui::GetContentRegionAvail().y;
    const float height =
        std::clamp(room / static_cast<float>(kStepCount), 2.0F * ImGui::GetTextLineHeight(), context.px(48));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    for (int k = 1; k <= kStepCount; ++k) {
        const Step step = static_cast<Step>(k);
        const std::string value = step == Step::BoundaryToFront ? "repeat" : stepFinding(moment, step);
        drawLine(context, step, presentedLine(step, shown, quads), value, live == step, height);
    }
    ImGui::PopStyleVar();
    ImGui::End();
    if (leave || escapes) {
        togglePresentation(context);
    }
}

} // namespace forefront::shell
