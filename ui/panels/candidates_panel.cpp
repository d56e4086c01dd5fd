#include "core/teaching/moment/moment.hpp"
#include "core/teaching/moment/short_texts.hpp"
#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/view/candidate_text.hpp"
#include "ui/workspace/view/chosen_candidate.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace forefront {

namespace {

constexpr const char *kDot = " \xc2\xb7 ";

/// The columns of the table with their right ends, as fractions of its width.
struct Column {
    const char *title;
    float end;
};
using Columns = std::array<Column, 7>;
constexpr Columns kColumns{{{"", 0.06F},
                            {"node", 0.19F},
                            {"\xce\xb1", 0.32F},
                            {"\xce\xb4(AC)", 0.46F},
                            {"\xce\xb4(CB)", 0.60F},
                            {"score", 0.73F},
                            {"verdict", 1.0F}}};
/// Those of the two-coloured front: the shape is not α but how near a candidate is to a square, or to half of one.
constexpr Columns kSquareColumns{{{"", 0.06F},
                                  {"node", 0.19F},
                                  {"shape", 0.345F},
                                  {"\xce\xb4", 0.47F},
                                  {"\xce\xb4", 0.60F},
                                  {"score", 0.73F},
                                  {"verdict", 1.0F}}};

const Columns &columnsOf(const AdvanceExplanation &e) {
    return e.coloured ? kSquareColumns : kColumns;
}

/// Returns δ worked out for a side: "δ(AC) = 0.95: min(L/ρ, ρ/L), L = 0.105, ρ = 0.1".
std::string deltaText(const char *side, double delta, double length, double rho) {
    return ui::format("\xce\xb4(%s) = %s = %s / %s = %.3f", side, length < rho ? "L/\xcf\x81" : "\xcf\x81/L",
                      ui::number(std::min(length, rho)).c_str(), ui::number(std::max(length, rho)).c_str(), delta);
}

std::string alphaText(const AdvanceExplanation &e, const CandidateTrace &c) {
    if (c.over.size() > 2) {
        return ui::format("\xce\xb1 = %.3f, the smallest of %d elements", c.alpha, static_cast<int>(c.over.size()) - 1);
    }
    const double product = cross(e.b - e.a, c.position - e.a);
    const double squares =
        distanceSquared(e.a, e.b) + distanceSquared(e.b, c.position) + distanceSquared(c.position, e.a);
    return ui::format("\xce\xb1 = 2\xe2\x88\x9a"
                      "3\xc2\xb7(AB\xc3\x97"
                      "AC) / (AB\xc2\xb2+BC\xc2\xb2+CA\xc2\xb2) = %.3f\xc2\xb7%s / %s = %.3f",
                      2.0 * std::numbers::sqrt3, ui::number(product).c_str(), ui::number(squares).c_str(), c.alpha);
}

/// Returns the score worked out by the rules of the run.
std::string scoreText(const AdvanceExplanation &e, const CandidateTrace &c) {
    if (e.rules.shapeWeight == 1.0 && e.rules.spacingWeight == 1.0) {
        return ui::format("score = %.3f%s%.3f%s%.3f = %.3f", c.alpha, kDot, c.deltaAC, kDot, c.deltaCB, c.score);
    }
    return "score = " + scoreFormula(e.rules) + ui::format(" = %.3f", c.score);
}

/// Returns the figures of a candidate of the two-coloured front, a line each.
std::vector<std::string> squareLines(const CandidateTrace &c) {
    const auto deltas = [&] {
        return ui::format("\xce\xb4 of its sides, against %s: %.3f and %.3f", ui::number(c.rho).c_str(), c.deltaAC,
                          c.deltaCB);
    };
    if (c.square != SquareKind::None) {
        return {std::string("A square that ") + squareText(c.square) + ui::format(": scaled Jacobian %.3f", c.alpha),
                deltas(), "Squares are tried in turn, before any search; the score is for comparison"};
    }
    const double product = c.alpha * c.deltaAC * c.deltaCB;
    std::vector<std::string> lines = {
        ui::format("Half a square: %.3f of 1, colour %d", c.alpha, c.colour), deltas(),
        ui::format("score = %.3f%s%.3f%s%.3f = %.3f", c.alpha, kDot, c.deltaAC, kDot, c.deltaCB, product)};
    if (c.node != kNoNode) {
        lines.back() += ui::format(", times 1.15 for a node of the front = %.3f", c.score);
    }
    return lines;
}

/// Returns why a candidate was accepted or rejected, in a sentence.
std::string verdictSentence(const AdvanceExplanation &e, std::size_t candidate) {
    const CandidateTrace &c = e.candidates[candidate];
    const auto tests = std::count_if(e.tests.begin(), e.tests.end(),
                                     [candidate](const TestTrace &t) { return t.candidate == candidate; });
    std::string text = std::string(verdictText(c.verdict));
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
    if (c.verdict != Verdict::NotTried && c.verdict != Verdict::Withdrawn) {
        text += tests == 0 ? "; no segment had to be tested"
                           : "; tested against " + std::to_string(tests) + (tests == 1 ? " segment" : " segments");
    }
    if (c.passes > 1) {
        text += ui::format("; \xce\x93 passes through this node %u times, and each pass was tried in turn", c.passes);
    }
    if (c.blocked && c.verdict == Verdict::Withdrawn) {
        text += ": " + clearanceText(c, e.rho);
    } else if (c.blocked) {
        text += c.blockA == c.blockB ? ui::format("; front node (%s, %s) is in the way", ui::number(c.blockA.x).c_str(),
                                                  ui::number(c.blockA.y).c_str())
                                     : ui::format("; front segment (%s, %s)\xe2\x80\x93(%s, %s) is in the way",
                                                  ui::number(c.blockA.x).c_str(), ui::number(c.blockA.y).c_str(),
                                                  ui::number(c.blockB.x).c_str(), ui::number(c.blockB.y).c_str());
    }
    return text;
}

class CandidatesPanel final : public Panel {
  public:
    const char *id() const override { return "candidates"; }
    const char *title() const override { return "Candidates"; }

    void draw(Shell &context) override {
        const Moment moment = momentOf(context.run.now());
        if (!moment || moment.candidates == 0) {
            ui::small(context,
                      moment ? "This advance has no candidates yet."
                             : "Step through a run to see the candidates of each advance, their scores and verdicts.",
                      true);
            ui::mark(context, "candidates/empty");
            return;
        }
        const std::optional<std::size_t> chosen = chosenCandidate(context.view, context.run.now());
        ImGui::PushFont(context.fonts.small);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
        drawTitles(context, columnsOf(*moment.advance));
        for (std::size_t i = 0; i < moment.candidates; ++i) {
            drawRow(context, moment, i, chosen == i);
        }
        ImGui::Dummy({0, context.px(5)});
        ImGui::PopStyleVar();
        ImGui::PopFont();
        if (chosen) {
            drawWorked(context, moment, *chosen);
        } else {
            ui::small(context, "Click a row to see its numbers, its tests and why it was rejected.", true);
        }
    }

  private:
    static void drawCells(WidgetContext &context, ImVec2 at, float width, const Columns &columns,
                          const std::array<std::string, kColumns.size()> &texts, Colour colour, Colour last) {
        ImDrawList &list = *ImGui::GetWindowDrawList();
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const bool isVerdict = i + 1 == columns.size();
            const float x = isVerdict ? at.x + columns[i - 1].end * width + context.px(8)
                                      : at.x + columns[i].end * width - ImGui::CalcTextSize(texts[i].c_str()).x;
            list.AddText({x, at.y}, isVerdict ? last : colour, texts[i].c_str());
        }
    }

    static void drawTitles(WidgetContext &context, const Columns &columns) {
        std::array<std::string, kColumns.size()> titles;
        std::ranges::transform(columns, titles.begin(), &Column::title);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x;
        drawCells(context, at, width, columns, titles, context.theme.muted, context.theme.muted);
        ImGui::Dummy({width, context.px(20)}); // leaves room for the outline of the first row
    }

    static void drawRow(Shell &context, const Moment &moment, std::size_t i, bool chosen) {
        const CandidateTrace &c = moment.advance->candidates[i];
        const Theme &theme = context.theme;
        const float width = ImGui::GetContentRegionAvail().x, height = context.px(24);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const std::string name = "candidates/" + std::to_string(i);
        if (ui::hitArea(name.c_str(), width, height)) {
            const SessionSnapshot &run = context.run.now();
            context.view.candidate =
                chosen ? std::nullopt : std::optional(CandidateChoice{run.shownRun, moment.advance->advance, i});
            context.animate();
        }
        ui::mark(context, name);
        const bool hovered = ImGui::IsItemHovered();
        if (hovered) {
            ui::tooltip(context, verdictText(moment.judged[i] ? c.verdict : Verdict::NotTried));
        }
        if (chosen || hovered) {
            ImGui::GetWindowDrawList()->AddRectFilled({at.x - context.px(4), at.y}, {at.x + width, at.y + height},
                                                      chosen ? theme.selectedRow : theme.hovered, context.px(4));
        }
        const auto known = [&](double value, int digits) {
            const float column = (kColumns[5].end - kColumns[4].end) * width;
            const int shown = column < ImGui::CalcTextSize("0.000  ").x ? std::min(digits, 2) : digits;
            return moment.scoresKnown ? ui::format("%.*f", shown, value) : std::string("\xe2\x80\x93");
        };
        const bool judged = moment.judged[i] && c.verdict != Verdict::NotTried;
        const Colour verdict = !judged             ? theme.muted
                               : chosen || hovered ? theme.text // the colours are too near to those of such rows
                               : c.verdict == Verdict::Accepted ? theme.accepted
                                                                : theme.bad;
        drawCells(context, {at.x, std::round(at.y + 0.5F * (height - ImGui::GetFontSize()))}, width,
                  columnsOf(*moment.advance),
                  {std::to_string(i + 1), shortName(c), known(c.alpha, 3), known(c.deltaAC, 2), known(c.deltaCB, 2),
                   known(c.score, 3), judged ? shortVerdict(c.verdict) : "\xe2\x80\x93"},
                  theme.text, verdict);
    }

    /// Writes the formulas with the numbers of a candidate substituted.
    static void drawWorked(Shell &context, const Moment &moment, std::size_t i) {
        const AdvanceExplanation &e = *moment.advance;
        const CandidateTrace &c = e.candidates[i];
        const Vec2 a = c.over.empty() ? e.a : c.over.front(), b = c.over.empty() ? e.b : c.over.back();
        std::vector<std::string> lines;
        if (moment.scoresKnown && e.coloured) {
            lines = squareLines(c);
        } else if (moment.scoresKnown) {
            lines = {alphaText(e, c), deltaText("AC", c.deltaAC, distance(a, c.position), c.rho),
                     deltaText("CB", c.deltaCB, distance(b, c.position), c.rho), scoreText(e, c)};
        }
        if (moment.judged[i]) {
            lines.push_back(verdictSentence(e, i));
        }
        for (const std::string &line : lines) {
            ui::small(context, line, true);
        }
        ui::mark(context, "candidates/worked");
    }
};

} // namespace

std::unique_ptr<Panel> makeCandidatesPanel() {
    return std::make_unique<CandidatesPanel>();
}

} // namespace forefront
