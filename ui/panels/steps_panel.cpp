#include "core/teaching/moment/moment.hpp"
#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/shortened.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/view/candidate_text.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace forefront {

namespace {

constexpr std::array<const char *, kStepCount> kShort{
    "Boundary becomes front \xce\x93",
    "Take base segment AB",
    "Evaluate \xcf\x81 at AB",
    "Place ideal point C",
    "Find candidate nodes",
    "Score \xce\xb1 \xc2\xb7 \xce\xb4(AC) \xc2\xb7 \xce\xb4(CB)",
    "Sort; drop C if too near",
    "Test AC, CB against \xce\x93",
    "Store ABC, update \xce\x93",
    "Stop when \xce\x93 = \xe2\x88\x85",
};

/// Returns the candidate whose score is shown: the accepted one once it is known, else the one scored last.
const CandidateTrace *scored(const Moment &moment) {
    const AdvanceExplanation &e = *moment.advance;
    for (std::size_t i = 0; i < moment.candidates; ++i) {
        if (moment.judged[i] && e.candidates[i].verdict == Verdict::Accepted) {
            return &e.candidates[i];
        }
    }
    const CandidateTrace *found = nullptr;
    for (std::size_t i = 0; i < e.events.size() && i <= moment.cursor + 1; ++i) { // sorted right after it is scored
        const TraceEvent &event = e.events[i];
        found = event.step == Step::Sort && event.candidate != kNoIndex ? &e.candidates[event.candidate] : found;
    }
    return found;
}

/// Returns the work of the background grid in a step: " of 23 in 4 cells".
std::string workText(const Moment &moment, Step step) {
    const StepWork &work = moment.work[static_cast<std::size_t>(step)];
    return work.segments == 0 ? std::string()
                              : " of " + ui::count(work.segments) + " in " + ui::count(work.cells) +
                                    (work.cells == 1 ? " cell" : " cells");
}

/// Returns the result of a step, shown at the right of its line; empty while unknown.
std::string finding(const Moment &moment, int step) {
    if (!moment || static_cast<int>(moment.step) < step) {
        return {};
    }
    const AdvanceExplanation &e = *moment.advance;
    switch (static_cast<Step>(step)) {
    case Step::TakeBase:
        return e.nodeA == kNoNode ? std::string()
                                  : std::to_string(index(e.nodeA)) + "\xe2\x80\x93" + std::to_string(index(e.nodeB));
    case Step::EvaluateSpacing:
        return ui::number(e.rho, 3);
    case Step::IdealPoint:
        return "(" + ui::number(e.ideal.x) + ", " + ui::number(e.ideal.y) + ")";
    case Step::FindCandidates:
        return ui::count(moment.candidates) + workText(moment, Step::FindCandidates);
    case Step::Score: {
        const CandidateTrace *best = scored(moment);
        return best == nullptr
                   ? std::string()
                   : ui::format("%.3f \xc2\xb7 %.2f \xc2\xb7 %.2f", best->alpha, best->deltaAC, best->deltaCB);
    }
    case Step::Test:
        return ui::count(moment.tests) + workText(moment, Step::Test);
    case Step::Update:
        return e.deferred ? "deferred" : std::string();
    default:
        return {};
    }
}

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

/// `rules`: of the run; null for the fast method.
std::string tip(const Moment &moment, Step step, const FrontRules *rules) {
    std::string text = stepTitle(step, rules);
    if (moment && step <= moment.step) {
        text += worked(moment, step);
    }
    if (moment && moment.work[static_cast<std::size_t>(step)].segments > 0) {
        const StepWork &work = moment.work[static_cast<std::size_t>(step)];
        text +=
            "\n" + ui::count(work.cells) + " grid cells visited, " + ui::count(work.segments) + " segments returned";
    }
    if (step == Step::Score) {
        text += ". A point that closes several segments gets the smallest \xce\xb1 of its elements; AC and CB are "
                "their outer "
                "sides.";
    }
    return rules == nullptr ? text : text + rulesText(*rules, step);
}

/// Returns the line of a step; that of the base and of the score follow the rules. `rules`: null for the fast method.
std::string lineOf(Step step, const FrontRules *rules) {
    if (step == Step::TakeBase && rules != nullptr) {
        return "Take " + std::string(wordOf(rules->base)) + " segment AB";
    }
    if (step == Step::Score && rules != nullptr && !(rules->shapeWeight == 1.0 && rules->spacingWeight == 1.0)) {
        return "Score " + scoreFormula(*rules);
    }
    return kShort[static_cast<std::size_t>(step) - 1];
}

class StepsPanel final : public Panel {
  public:
    const char *id() const override { return "steps"; }
    const char *title() const override { return "Steps"; }

    void draw(Shell &context) override {
        const SessionSnapshot &run = context.run.now();
        const Moment moment = momentOf(run);
        const int live = liveStep(run, moment);
        const FrontRules rules = moment ? moment.advance->rules : context.document.current()->options.rules;
        const FrontRules *const shown = context.run.method() == Method::Classic ? &rules : nullptr;
        const float width = ImGui::GetContentRegionAvail().x, height = context.px(24);
        ImDrawList &list = *ImGui::GetWindowDrawList();
        ImGui::PushFont(context.fonts.small);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
        for (int step = 1; step <= kStepCount; ++step) {
            const ImVec2 at = ImGui::GetCursorScreenPos();
            ImGui::Dummy({width, height});
            ui::mark(context, "steps/" + std::to_string(step));
            const bool here = step == live;
            if (here) {
                list.AddRectFilled(at, {at.x + width, at.y + height}, context.theme.selectedRow, context.px(4));
                list.AddRectFilled(at, {at.x + context.px(3), at.y + height}, context.theme.accent, context.px(2));
            }
            const float y = at.y + (height - ImGui::GetFontSize()) / 2;
            const std::string number = std::to_string(step);
            const float numberWidth = ImGui::CalcTextSize(number.c_str()).x;
            const Colour colour = here ? context.theme.text : context.theme.muted;
            list.AddText({at.x + context.px(22) - numberWidth, y}, colour, number.c_str());
            const std::string found = finding(moment, step);
            const float right = at.x + width - context.px(6) - ImGui::CalcTextSize(found.c_str()).x;
            list.AddText({right, y}, context.theme.text, found.c_str());
            ui::shortened(context, Pixel(at.x + context.px(31), y), right - context.px(6),
                          lineOf(static_cast<Step>(step), shown), colour);
            if (ImGui::IsItemHovered()) {
                ui::tooltip(context, tip(moment, static_cast<Step>(step), shown));
            }
            if (ImGui::IsItemClicked()) {
                context.actions.run(std::string("glossary.") + kTerms[static_cast<std::size_t>(step - 1)], context);
            }
        }
        ImGui::PopStyleVar();
        ImGui::PopFont();
    }

  private:
    static int liveStep(const SessionSnapshot &run, const Moment &moment) {
        if (moment) {
            return static_cast<int>(moment.step);
        }
        if (run.state == RunState::Empty || run.state == RunState::Failed) {
            return 0;
        }
        if (run.complete && run.advance == run.known) {
            return static_cast<int>(Step::Finish);
        }
        return run.advance == 0 ? static_cast<int>(Step::BoundaryToFront) : 0;
    }
};

} // namespace

std::unique_ptr<Panel> makeStepsPanel() {
    return std::make_unique<StepsPanel>();
}

} // namespace forefront
