#include "ui/panels/limits_list.hpp"

#include "core/drawing/commands/limit_fix.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/judging.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace forefront {

namespace {

/// Width of the field of a limit, and the column of its verdict; design pixels.
constexpr float kField = 52.0F;
constexpr double kLimitLabel = 160.0, kVerdict = 218.0;

void drawIcon(const char *symbol, Colour colour) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(symbol);
    ImGui::PopStyleColor();
}

/// Draws links that lead from one bad place to the next, in the order of the list.
void drawPlaces(Shell &context, const LimitVerdict &verdict, const std::string &name) {
    const MeshPart part = infoOf(limitInfo(verdict.limit).measure).part;
    const auto at = std::find_if(verdict.places.begin(), verdict.places.end(), [&](const LimitPlace &place) {
        return context.probe.chosen == MeshPick{part, place.part};
    });
    const bool last = at == verdict.places.end() || at + 1 == verdict.places.end();
    const auto next = last ? verdict.places.begin() : at + 1;
    if (ui::link(context, name + "/next", ui::count(verdict.broken) + " \xe2\x80\xba")) {
        goToPart(context, {part, next->part});
    }
    ui::tooltip(context, toString(verdict) + "\nClick to go to the next place");
}

void drawVerdict(Shell &context, const LimitVerdict &verdict, const std::string &name) {
    if (verdict.judged == 0 && !verdict.met()) {
        drawIcon(icon::kUnknown, context.theme.muted);
    } else {
        drawIcon(verdict.met() ? icon::kCheck : icon::kError, verdict.met() ? context.theme.good : context.theme.bad);
    }
    ui::mark(context, name + (verdict.met() ? "/kept" : verdict.judged == 0 ? "/unknown" : "/broken"));
    ui::tooltip(context, toString(verdict));
    if (verdict.broken > 0) {
        ImGui::SameLine(0, context.px(5));
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() + ImGui::GetStyle().FramePadding.y); // level with the icon
        drawPlaces(context, verdict, name);
    }
}

/// Draws a link that changes the setting that a broken limit depends on, and says how.
void drawFix(Shell &context, const LimitVerdict &verdict, const std::string &name) {
    if (context.run.showsFile()) {
        return; // the mesh does not come from the drawing
    }
    std::optional<LimitFix> fix = fixOf(*context.document.current(), verdict, context.judgement->of.spacing.get());
    if (!fix) {
        return;
    }
    ImGui::SetCursorPosX(context.px(20));
    if (ui::link(context, name + "/fix", "Fix: " + fix->change)) {
        tryFix(context, verdict, *std::move(fix));
    }
    ui::tooltip(context, "Change this setting, and mesh again. Undo takes it back, and so does a mesh that is no "
                         "better.");
}

void drawLimit(Shell &context, MeshLimit limit) {
    const LimitInfo &info = limitInfo(limit);
    const std::string name = std::string("checks/") + std::string(wordOf(limit));
    std::string label = info.name;
    label.front() = static_cast<char>(label.front() - 'a' + 'A');
    ui::rowLabel(context, label.c_str(), kLimitLabel);
    ui::tooltip(context, info.meaning);
    std::optional<double> value = context.document.current()->limits[limit];
    if (form::optionalField(context, name, value, "off", kField)) {
        setLimit(context, limit, value);
    }
    ui::tooltip(context, info.meaning);
    const std::vector<LimitVerdict> &verdicts = context.judgement->verdicts;
    const auto verdict =
        std::find_if(verdicts.begin(), verdicts.end(), [limit](const LimitVerdict &v) { return v.limit == limit; });
    if (verdict != verdicts.end()) {
        ImGui::SameLine(context.px(kVerdict));
        drawVerdict(context, *verdict, name);
        drawFix(context, *verdict, name);
    }
}

/// Lists the faults of a mesh that was read from a file.
void drawMeshFaults(Shell &context) {
    const Judgement &judgement = *context.judgement;
    if (!judgement.of.verify) {
        return;
    }
    const bool valid = !hasErrors(judgement.faults); // there may be warnings
    drawIcon(valid ? icon::kCheck : icon::kError, valid ? context.theme.good : context.theme.bad);
    ImGui::SameLine(context.px(20));
    ui::small(context, valid ? "The mesh is valid" : "Mesh faults");
    ui::mark(context, valid ? "checks/mesh/valid" : "checks/mesh/faulty");
    for (std::size_t k = 0; k < judgement.faults.size(); ++k) {
        const Diagnostic &fault = judgement.faults[k];
        ImGui::SetCursorPosX(context.px(20));
        ui::small(context, fault.message, true);
        if (fault.at) {
            ImGui::SetCursorPosX(context.px(20));
            if (ui::link(context, "checks/mesh/goto/" + std::to_string(k),
                         ui::format("go to (%.6g, %.6g)", fault.at->x, fault.at->y))) {
                context.view.goTo(*fault.at, context.platform.now());
            }
        }
    }
}

} // namespace

void drawLimits(Shell &context) {
    ImGui::PushFont(context.fonts.small);
    drawMeshFaults(context);
    for (const MeshLimit limit : valuesOf<MeshLimit>()) {
        drawLimit(context, limit);
    }
    ImGui::PopFont();
}

} // namespace forefront
