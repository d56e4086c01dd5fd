#include "core/arrangement/repair.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/panels/limits_list.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>

namespace forefront {
namespace {

/// Lists the faults of the drawing, updated a moment after every edit, and the limits that the mesh must meet.
class ChecksPanel final : public Panel {
  public:
    const char *id() const override { return "checks"; }
    const char *title() const override { return "Checks"; }
    PanelPlace place() const override { return PanelPlace::Tabbed; }

    void draw(Shell &context) override {
        if (context.document.current()->shapes.empty()) {
            ui::small(context, "The drawing is empty. Press P and click the corners of a polygon.", true);
            ui::mark(context, "checks/empty");
        } else {
            drawDrawing(context);
        }
        ui::heading(context, "Mesh limits");
        drawLimits(context);
    }

  private:
    static void drawDrawing(Shell &context) {
        const Diagnostics &faults = context.preview->faults;
        const auto errors = std::count_if(faults.begin(), faults.end(),
                                          [](const Diagnostic &d) { return d.severity == Severity::Error; });
        ImGui::AlignTextToFramePadding();
        ImGui::PushStyleColor(ImGuiCol_Text, errors > 0 ? context.theme.bad : context.theme.good);
        ImGui::TextUnformatted(errors > 0 ? icon::kError : icon::kCheck);
        ImGui::PopStyleColor();
        ImGui::SameLine();
        ImGui::TextUnformatted(
            errors > 0 ? (ui::count(static_cast<std::uint64_t>(errors)) + (errors == 1 ? " error" : " errors")).c_str()
                       : "Ready to mesh");
        ui::mark(context, "checks/summary");
        if (anyRepairable(faults)) {
            ImGui::SameLine(ImGui::GetContentRegionMax().x - context.px(78));
            if (ui::button(context, "checks/repair", "Repair", ui::ButtonKind::Primary, true, 78.0F)) {
                context.actions.run("edit.repair", context);
            }
            ui::tooltip(context, "Split segments where they cross, merge duplicates and drop parts outside the domain. "
                                 "The log reports every change.");
        }
        drawList(context, faults);
    }

    static void drawList(Workspace &context, const Diagnostics &faults) {
        ImGui::PushFont(context.fonts.small);
        for (std::size_t k = 0; k < faults.size(); ++k) {
            const Diagnostic &fault = faults[k];
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
        }
        ImGui::PopFont();
    }
};

} // namespace

std::unique_ptr<Panel> makeChecksPanel() {
    return std::make_unique<ChecksPanel>();
}

} // namespace forefront
