#include "core/drawing/arrangement/repair/repair.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/panels/limits_list.hpp"
#include "ui/panels/unfinished_note.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/checks_summary.hpp"

#include <imgui.h>

#include <algorithm>

namespace forefront {
namespace {

/// Lists the faults of the drawing, updated a moment after every edit, and the limits that the mesh must meet.
class ChecksPanel final : public Panel {
  public:
    const char *id() const override { return "checks"; }
    const char *title() const override { return "Checks"; }

    void draw(Shell &context) override {
        const ChecksSummary summary = checksSummary(context);
        if (summary.state == ChecksSummary::State::None) {
            ui::small(context, "The drawing is empty. Press P and click the corners of a polygon.", true);
            ui::mark(context, "checks/empty");
        } else {
            drawSummary(context, summary);
        }
        drawList(context, context.preview->faults);
        ui::heading(context, "Mesh limits");
        drawLimits(context);
    }

    std::vector<ContextGroup> menu(Shell &) override {
        return {actionsOf({"edit.repair", "view.firstFault", "run.mesh"})};
    }

  private:
    /// Draws the verdict of all checks in one line.
    static void drawSummary(Shell &context, const ChecksSummary &summary) {
        const bool violated = summary.state == ChecksSummary::State::Violated;
        if (summary.state == ChecksSummary::State::Unfinished) {
            drawUnfinishedNote(context, "checks");
            return;
        }
        ImGui::AlignTextToFramePadding();
        ImGui::PushStyleColor(ImGuiCol_Text, violated ? context.theme.bad : context.theme.good);
        ImGui::TextUnformatted(violated ? icon::kError : icon::kCheck);
        ImGui::PopStyleColor();
        ImGui::SameLine();
        ui::wrappedText(summary.line);
        ui::mark(context, violated ? "checks/violated" : "checks/summary");
        drawCures(context);
    }

    /// Draws a row of buttons for what can be done about the faults of the drawing.
    static void drawCures(Shell &context) {
        const bool repairs = anyRepairable(context.preview->faults);
        if (repairs) {
            if (ui::button(context, "checks/repair", "Repair", ui::ButtonKind::Primary, true, 78.0F)) {
                context.actions.run("edit.repair", context);
            }
            ui::tooltip(context, "Split segments where they cross, merge duplicates and drop parts outside the domain. "
                                 "The log reports every change.");
        }
        const Action *const combine = context.actions.find("edit.combine");
        if (combine == nullptr || !combine->enabled(context)) {
            return;
        }
        if (repairs) {
            ImGui::SameLine(0, context.px(6));
        }
        if (ui::button(context, "checks/combine", "Union\xe2\x80\xa6", ui::ButtonKind::Plain, true, 78.0F)) {
            context.actions.run("edit.combine", context);
        }
        ui::tooltip(context, "Join the shapes that overlap into one, with a preview; or subtract, intersect or divide "
                             "them");
    }

    static void drawList(Shell &context, const Diagnostics &faults) {
        ImGui::PushFont(context.fonts.small);
        for (std::size_t k = 0; k < faults.size(); ++k) {
            const Diagnostic &fault = faults[k];
            const ImVec2 at = ImGui::GetCursorScreenPos();
            const float width = ImGui::GetContentRegionAvail().x;
            const bool error = fault.severity == Severity::Error;
            ImGui::PushStyleColor(ImGuiCol_Text, error ? context.theme.bad : context.theme.warn);
            ImGui::TextUnformatted(error ? icon::kError : icon::kWarning);
            ImGui::PopStyleColor();
            ImGui::SameLine(context.px(20));
            ui::wrappedText(fault.message);
            if (!fault.advice.empty()) {
                ImGui::SetCursorPosX(context.px(20));
                ui::small(context, fault.advice, true);
            }
            if (fault.at) {
                ImGui::SetCursorPosX(context.px(20));
                if (ui::link(context, "checks/goto/" + std::to_string(k),
                             ui::format("go to (%.6g, %.6g)", fault.at->x, fault.at->y))) {
                    context.view.goTo(*fault.at, context.platform.now());
                }
            }
            const ImVec2 end{at.x + width, ImGui::GetCursorScreenPos().y};
            if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(at, end) &&
                ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
                openMenu(context, fault);
            }
        }
        ImGui::PopFont();
    }

    static void openMenu(Shell &context, const Diagnostic &fault) {
        ContextGroup group;
        if (fault.at) {
            group.push_back(
                commandOf("goTo", "Go there", [at = *fault.at](Shell &c) { c.view.goTo(at, c.platform.now()); }));
        }
        group.push_back(copyCommand("copyMessage", "Copy message", toString(fault)));
        context.menu.open({std::move(group), actionsOf({"edit.repair"})});
    }
};

} // namespace

std::unique_ptr<Panel> makeChecksPanel() {
    return std::make_unique<ChecksPanel>();
}

} // namespace forefront
