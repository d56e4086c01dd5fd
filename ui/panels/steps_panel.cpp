#include "core/teaching/moment/moment.hpp"
#include "core/teaching/moment/short_texts.hpp"
#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/shortened.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/view/candidate_text.hpp"
#include "ui/workspace/view/step_text.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace forefront {

namespace {

/// Returns how ρ of the field was found, and how it was clamped.
std::string spacingText(const AdvanceExplanation &e) {
    const double base = distance(e.a, e.b), share = 100.0 * e.rules.rhoAtC;
    std::string text = "\n\xcf\x81 = " + ui::number(e.fieldRho);
    if (e.rules.rhoAtC == 0.0) {
        text += " at the midpoint";
    } else if (e.rules.rhoAtC == 1.0) {
        text += " near C";
    } else {
        text +=
            ", a mean of the midpoint (" + ui::number(100.0 - share) + " %) and near C (" + ui::number(share) + " %)";
    }
    return text + ui::format("; with |AB| = %s, clamped to %s \xe2\x80\xa6 %s: \xcf\x81 = %s", ui::number(base).c_str(),
                             ui::number(e.rules.minRho * base).c_str(), ui::number(e.rules.maxRho * base).c_str(),
                             ui::number(e.rho).c_str());
}

/// Returns what step 7 found: the order of the candidates, and why C was withdrawn.
std::string sortText(const AdvanceExplanation &e) {
    std::string text;
    for (const CandidateTrace &candidate : e.candidates) {
        if (candidate.verdict == Verdict::Withdrawn && candidate.blocked) {
            text += "\nC withdrawn: " + clearanceText(candidate, e.rho);
        }
    }
    return text;
}

std::string testText(const Moment &moment) {
    const auto &candidates = moment.advance->candidates;
    std::size_t tested = 0, rejected = 0;
    for (std::size_t i = 0; i < moment.candidates; ++i) {
        const Verdict verdict = moment.judged[i] ? candidates[i].verdict : Verdict::NotTried;
        const bool decided = verdict != Verdict::NotTried && verdict != Verdict::Withdrawn;
        tested += decided ? 1 : 0;
        rejected += decided && verdict != Verdict::Accepted ? 1 : 0;
    }
    return "\n" + ui::count(tested) + (tested == 1 ? " candidate" : " candidates") + " tested, " + ui::count(rejected) +
           " rejected; " + ui::count(moment.tests) + (moment.tests == 1 ? " segment" : " segments") +
           " of \xce\x93 tested exactly";
}

std::string updateText(const AdvanceExplanation &e) {
    if (e.deferred) {
        return "\nno candidate passed: AB is put back once";
    }
    return "\n" + ui::count(e.elements) + (e.elements == 1 ? " element" : " elements") + " stored, with the apex (" +
           ui::number(e.apex.x) + ", " + ui::number(e.apex.y) + ")";
}

/// Returns the formula of a step with the numbers substituted; empty for steps without one.
std::string worked(const Moment &moment, Step step) {
    const AdvanceExplanation &e = *moment.advance;
    const double base = distance(e.a, e.b);
    switch (step) {
    case Step::EvaluateSpacing:
        return spacingText(e);
    case Step::IdealPoint:
        return ui::format("\nheight \xe2\x88\x9a(\xcf\x81\xc2\xb2 \xe2\x88\x92 |AB|\xc2\xb2/4) = %s above AB, "
                          "at least %s |AB| = %s",
                          ui::number(std::sqrt(std::max(0.0, e.rho * e.rho - 0.25 * base * base))).c_str(),
                          ui::number(e.rules.minHeight).c_str(), ui::number(e.rules.minHeight * base).c_str());
    case Step::FindCandidates:
        return e.searchRadius == 0.0 ? std::string() : "\nfront nodes within " + ui::number(e.searchRadius) + " of C";
    case Step::Sort:
        return sortText(e);
    case Step::Test:
        return testText(moment);
    case Step::Update:
        return moment.cursor < e.events.size() ? std::string() : updateText(e);
    default:
        return {};
    }
}

/// Returns the same for the front of quadrilaterals.
std::string workedSquare(const Moment &moment, Step step) {
    const AdvanceExplanation &e = *moment.advance;
    switch (step) {
    case Step::TakeBase:
        return e.diagonal ? std::string("\nA and B have one colour: AB is the diagonal of half a square")
                          : "\nA and B have two colours: AB is a leg, of row " + ui::count(e.row + 1);
    case Step::EvaluateSpacing:
        return "\n\xcf\x81 = " + ui::number(e.fieldRho) + ", used with |AB| = " + ui::number(distance(e.a, e.b)) +
               ": " + ui::number(e.rho);
    case Step::FindCandidates:
        return e.searchRadius == 0.0 ? std::string("\na square was made; there was no search")
                                     : "\nfront nodes within " + ui::number(e.searchRadius) + " of C";
    case Step::Sort:
        return sortText(e);
    case Step::Test:
        return testText(moment);
    case Step::Update: {
        const char *const made = e.deferred                        ? "no candidate passed: AB is put back once"
                                 : e.square == SquareKind::None    ? "half a square stored"
                                 : e.square == SquareKind::Opening ? "a square with two new nodes stored"
                                 : e.square == SquareKind::Row     ? "a square with one new node stored"
                                                                   : "a square without a new node stored";
        return moment.cursor < e.events.size() ? std::string() : std::string("\n") + made;
    }
    default:
        return {};
    }
}

/// The glossary term that explains each step.
constexpr std::array<const char *, kStepCount> kTerms{"domain", "base",  "spacing",   "ideal-point", "candidates",
                                                      "score",  "score", "rejection", "front",       "closing"};

/// Returns the rules of the classic method that belong to a step, a line each, with their origins.
std::string rulesText(const FrontRules &rules, Step step) {
    std::string text;
    for (const FrontRule rule : valuesOf<FrontRule>()) {
        const FrontRuleInfo &info = frontRuleInfo(rule);
        if (info.step == static_cast<int>(step) && (rule != FrontRule::Seed || rules.base == BaseRule::Random)) {
            const std::string unit = info.unit;
            text += std::string("\n") + info.name + ": " + valueText(rules, rule) + (unit.empty() ? "" : " " + unit) +
                    " (" + originText(info.origin) + ")";
        }
    }
    return text;
}

/// `rules`: of the run; null for the fast method. `quads`: it is one of quadrilaterals.
std::string tip(const Moment &moment, Step step, const FrontRules *rules, bool quads) {
    std::string text = quads ? colouredStepTitle(step) : stepTitle(step, rules);
    if (moment && step <= moment.step) {
        text += quads ? workedSquare(moment, step) : worked(moment, step);
    }
    if (moment && moment.work[static_cast<std::size_t>(step)].segments > 0) {
        const StepWork &work = moment.work[static_cast<std::size_t>(step)];
        text +=
            "\n" + ui::count(work.cells) + " grid cells visited, " + ui::count(work.segments) + " segments returned";
    }
    if (step == Step::Score && !quads) {
        text += ". A point that closes several segments gets the smallest \xce\xb1 of its elements; AC and CB are "
                "their outer "
                "sides.";
    }
    return rules == nullptr ? text : text + rulesText(*rules, step);
}

class StepsPanel final : public Panel {
  public:
    const char *id() const override { return "steps"; }
    const char *title() const override { return "Steps"; }

    void draw(Shell &context) override {
        const SessionSnapshot &run = context.run.now();
        const Moment moment = momentOf(run);
        const std::optional<Step> live = liveStep(run, moment);
        const bool quads = context.run.showsQuads();
        const FrontRules rules = moment ? moment.advance->rules : context.document.current()->options.rules;
        const FrontRules *const shown = context.run.method() == Method::Classic && !quads ? &rules : nullptr;
        const float width = ImGui::GetContentRegionAvail().x, height = context.px(24);
        ImDrawList &list = *ImGui::GetWindowDrawList();
        ImGui::PushFont(context.fonts.small);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
        for (int step = 1; step <= kStepCount; ++step) {
            const ImVec2 at = ImGui::GetCursorScreenPos();
            ImGui::Dummy({width, height});
            ui::mark(context, "steps/" + std::to_string(step));
            const bool here = live == static_cast<Step>(step);
            if (here) {
                list.AddRectFilled(at, {at.x + width, at.y + height}, context.theme.selectedRow, context.px(4));
                list.AddRectFilled(at, {at.x + context.px(3), at.y + height}, context.theme.accent, context.px(2));
            }
            const float y = at.y + (height - ImGui::GetFontSize()) / 2;
            const std::string number = std::to_string(step);
            const float numberWidth = ImGui::CalcTextSize(number.c_str()).x;
            const Colour colour = here ? context.theme.text : context.theme.muted;
            list.AddText({at.x + context.px(22) - numberWidth, y}, colour, number.c_str());
            const std::string found = stepFinding(moment, static_cast<Step>(step));
            const float right = at.x + width - context.px(6) - ImGui::CalcTextSize(found.c_str()).x;
            list.AddText({right, y}, context.theme.text, found.c_str());
            ui::shortened(context, Pixel(at.x + context.px(31), y), right - context.px(6),
                          quads ? squareStepLine(static_cast<Step>(step)) : stepLine(static_cast<Step>(step), shown),
                          colour);
            if (ImGui::IsItemHovered()) {
                ui::tooltip(context, tip(moment, static_cast<Step>(step), shown, quads));
            }
            if (ImGui::IsItemClicked()) {
                context.actions.run(std::string("glossary.") + kTerms[static_cast<std::size_t>(step - 1)], context);
            }
        }
        ImGui::PopStyleVar();
        ImGui::PopFont();
    }
};

} // namespace

std::unique_ptr<Panel> makeStepsPanel() {
    return std::make_unique<StepsPanel>();
}

} // namespace forefront
