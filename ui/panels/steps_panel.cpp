#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/shortened.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/view/moment.hpp"

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
    "Evaluate \xcf\x81 at its midpoint",
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

/// Returns the formula of a step with the numbers substituted; empty for steps without one.
std::string worked(const AdvanceExplanation &e, Step step) {
    const double base = distance(e.a, e.b);
    switch (step) {
    case Step::EvaluateSpacing:
        return ui::format("\n\xcf\x81 = %s here; with |AB| = %s, clamped to %s \xe2\x80\xa6 %s: \xcf\x81 = %s",
                          ui::number(e.fieldRho).c_str(), ui::number(base).c_str(), ui::number(0.55 * base).c_str(),
                          ui::number(2.0 * base).c_str(), ui::number(e.rho).c_str());
    case Step::IdealPoint:
        return ui::format("\nheight \xe2\x88\x9a(\xcf\x81\xc2\xb2 \xe2\x88\x92 |AB|\xc2\xb2/4) = %s above AB, "
                          "at least |AB|/2 = %s",
                          ui::number(std::sqrt(std::max(0.0, e.rho * e.rho - 0.25 * base * base))).c_str(),
                          ui::number(0.5 * base).c_str());
    case Step::FindCandidates:
        return e.searchRadius == 0.0 ? std::string() : "\nfront nodes within " + ui::number(e.searchRadius) + " of C";
    default:
        return {};
    }
}

/// The glossary term that explains each step.
constexpr std::array<const char *, kStepCount> kTerms{"domain", "base",  "spacing",   "ideal-point", "candidates",
                                                      "score",  "score", "rejection", "front",       "closing"};

std::string tip(const Moment &moment, Step step) {
    std::string text = stepTitle(step);
    if (moment && step <= moment.step) {
        text += worked(*moment.advance, step);
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
    return text;
}

class StepsPanel final : public Panel {
  public:
    const char *id() const override { return "steps"; }
    const char *title() const override { return "Steps"; }

    void draw(Shell &context) override {
        const SessionSnapshot &run = context.run.now();
        const Moment moment = momentOf(run);
        const int live = liveStep(run, moment);
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
                          kShort[static_cast<std::size_t>(step - 1)], colour);
            if (ImGui::IsItemHovered()) {
                ui::tooltip(context, tip(moment, static_cast<Step>(step)));
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
