#include "core/teaching/lesson/lesson_value.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/teaching/markup/text_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace forefront {

namespace {

/// The figures of the mesh shown. A front of quadrilaterals has them only with its mesh, δ is measured only on one.
constexpr std::array kOfMesh = {LessonValue::MinAlpha, LessonValue::MeanAlpha, LessonValue::MeanDelta};

std::optional<double> ofAdvance(LessonValue value, const AdvanceExplanation &advance) {
    const auto &candidates = advance.candidates;
    const auto winner = std::find_if(candidates.begin(), candidates.end(),
                                     [](const CandidateTrace &c) { return c.verdict == Verdict::Accepted; });
    const bool won = winner != candidates.end();
    switch (value) {
    case LessonValue::Base:
        return distance(advance.a, advance.b);
    case LessonValue::Rho:
        return advance.rho;
    case LessonValue::FieldRho:
        return advance.fieldRho;
    case LessonValue::Radius:
        return advance.searchRadius;
    case LessonValue::Candidates:
        return static_cast<double>(candidates.size());
    case LessonValue::Winner:
        return won ? static_cast<double>(winner - candidates.begin() + 1) : 0.0;
    case LessonValue::Rejected:
        return static_cast<double>(std::count_if(candidates.begin(), candidates.end(), [](const CandidateTrace &c) {
            return c.verdict != Verdict::Accepted && c.verdict != Verdict::NotTried && c.verdict != Verdict::Withdrawn;
        }));
    case LessonValue::Tests:
        return static_cast<double>(advance.tests.size());
    case LessonValue::Cells:
        return static_cast<double>(advance.cells.size());
    case LessonValue::Segments:
        return static_cast<double>(advance.delivered);
    case LessonValue::Alpha:
        return won ? std::optional(winner->alpha) : std::nullopt;
    case LessonValue::Square:
        return advance.coloured ? std::optional(static_cast<double>(advance.square)) : std::nullopt;
    case LessonValue::Row:
        return advance.coloured ? std::optional(advance.row + 1.0) : std::nullopt;
    case LessonValue::Score:
        return won ? std::optional(winner->score) : std::nullopt;
    default:
        return std::nullopt;
    }
}

/// Returns true if a run shows a step of the clean-up of quadrilaterals.
bool cleansUp(const SessionSnapshot &run) {
    return run.improvement != nullptr && run.improvement->quads;
}

double cellsMean(const WorkCounters &work) {
    return work.elements == 0 ? 0.0 : static_cast<double>(work.cellsVisited) / static_cast<double>(work.elements);
}

/// Formats a value with four significant digits, a count with all its digits.
std::string text(double value) {
    const bool whole = value == std::floor(value) && std::abs(value) < 1e15;
    return numberText(value, whole ? 15 : 4);
}

} // namespace

std::optional<double> valueOf(LessonValue value, const LessonState &state) {
    const SessionSnapshot &run = state.run;
    const bool hasRun = run.state != RunState::Empty && run.state != RunState::Failed;
    if (value == LessonValue::Chosen) {
        return state.chosen ? static_cast<double>(*state.chosen + 1) : 0.0;
    }
    if (value >= LessonValue::Base) {
        return run.explanation ? ofAdvance(value, *run.explanation) : std::nullopt;
    }
    if (!hasRun) {
        return std::nullopt;
    }
    switch (value) {
    case LessonValue::Advance:
        return static_cast<double>(run.advance);
    case LessonValue::Finished:
        return run.atEnd() ? 1.0 : 0.0;
    case LessonValue::Front:
        return static_cast<double>(run.frontSegments);
    case LessonValue::Elements:
        return static_cast<double>(run.work.elements);
    case LessonValue::NewNodes:
        return static_cast<double>(run.work.newNodes);
    case LessonValue::Deferrals:
        return static_cast<double>(run.work.deferrals);
    case LessonValue::Forced:
        return static_cast<double>(run.work.forced);
    case LessonValue::FrontMean:
        return run.work.frontMean();
    case LessonValue::Delivered:
        return run.work.neighboursMean();
    case LessonValue::Considered:
        return run.work.consideredMean();
    case LessonValue::Tested:
        return run.work.testsMean();
    case LessonValue::CellsMean:
        return cellsMean(run.work);
    case LessonValue::MinAlpha:
        return run.quality.alphaMin;
    case LessonValue::MeanAlpha:
        return run.quality.alphaMean;
    case LessonValue::MeanDelta:
        return run.quality.deltaMean;
    case LessonValue::Irregular:
        return cleansUp(run) ? std::optional(static_cast<double>(run.improvement->quadsAfter.irregular)) : std::nullopt;
    case LessonValue::MinJacobian:
        return cleansUp(run) ? std::optional(run.improvement->quadsAfter.jacobianMin) : std::nullopt;
    case LessonValue::ImproveStep:
        return static_cast<double>(run.improveStep);
    case LessonValue::ImproveSteps:
        return static_cast<double>(run.improveSteps);
    default:
        return std::nullopt;
    }
}

bool needsMesh(LessonValue value) {
    return std::ranges::find(kOfMesh, value) != kOfMesh.end();
}

bool needsMesh(std::string_view text) {
    return std::ranges::any_of(kOfMesh, [text](LessonValue value) {
        return text.find('{' + std::string(wordOf(value)) + '}') != std::string_view::npos;
    });
}

std::string withValues(std::string_view pattern, const LessonState &state) {
    return withValuesReplaced(pattern, [&](std::string_view word) -> std::optional<std::string> {
        const auto value = fromWord<LessonValue>(word);
        const auto number = value ? valueOf(*value, state) : std::nullopt;
        return number ? text(*number) : "\xe2\x80\x93";
    });
}

bool holds(const LessonCondition &condition, const LessonState &state) {
    const auto value = valueOf(condition.value, state);
    const auto bound = condition.other ? valueOf(*condition.other, state) : std::optional(condition.number);
    if (!value || !bound) {
        return false;
    }
    switch (condition.relation) {
    case LessonRelation::Is:
        return std::abs(*value - *bound) <= condition.within;
    case LessonRelation::Above:
        return *value > *bound;
    case LessonRelation::Below:
        return *value < *bound;
    }
    return false;
}

} // namespace forefront
