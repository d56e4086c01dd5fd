#pragma once

#include "core/engine/base/enum_words.hpp"
#include "core/engine/session/snapshot.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace forefront {

/// A number that describes the state of a run. Lessons show such values in their text and compare answers with them.
enum class LessonValue : std::uint8_t {
    Advance,      ///< advances done
    Finished,     ///< 1 at the end of the run, else 0
    Front,        ///< segments of Γ
    Elements,     ///< made so far
    NewNodes,     ///< made so far
    Deferrals,    ///< so far
    Forced,       ///< elements that the closing stage has made so far
    FrontMean,    ///< Nb
    Delivered,    ///< Nc
    Considered,   ///< Ns
    Tested,       ///< Nt
    CellsMean,    ///< cells of the grid visited, per element
    MinAlpha,     ///< of the mesh shown
    MeanAlpha,    ///< of the mesh shown
    MeanDelta,    ///< of the mesh shown
    ImproveStep,  ///< steps of the improvement done
    ImproveSteps, ///< all steps of the improvement; 0 before the front has been finished once
    Irregular,    ///< of a step of the clean-up of quadrilaterals: irregular nodes after it
    MinJacobian,  ///< likewise: minimum scaled Jacobian
    Base,         ///< length of AB; this value and all further ones belong to the advance shown
    Rho,          ///< ρ used, after clamping
    FieldRho,     ///< ρ of the node spacing function
    Radius,       ///< of the search around C
    Candidates,   ///< number of candidates
    Winner,       ///< rank of the accepted candidate; 0: none
    Rejected,     ///< candidates that were tested and rejected
    Tests,        ///< exact tests of segments
    Cells,        ///< cells visited
    Segments,     ///< segments delivered by the grid
    Alpha,        ///< α of the accepted candidate
    Score,        ///< of the accepted candidate
    Square,       ///< of quadrilaterals: 1 continues a row, 2 opens one, 3 closes a gap, 0 half a square or nothing
    Row,          ///< of quadrilaterals: the row of AB, from 1
    Chosen        ///< rank of the candidate that the learner chose in the Candidates panel; 0: none
};

template <>
struct EnumWords<LessonValue> {
    static constexpr auto kLast = LessonValue::Chosen;
    static constexpr std::array<std::string_view, 34> kList = {
        "advance",      "finished",      "front",     "elements",     "new-nodes",
        "deferrals",    "forced",        "Nb",        "Nc",           "Ns",
        "Nt",           "cells",         "min-alpha", "mean-alpha",   "mean-delta",
        "improve-step", "improve-steps", "irregular", "min-jacobian", "base",
        "rho",          "field-rho",     "radius",    "candidates",   "winner",
        "rejected",     "tests",         "visited",   "delivered",    "alpha",
        "score",        "square",        "row",       "chosen"};
};

/// The state that lesson values are read from.
struct LessonState {
    const SessionSnapshot &run;
    std::optional<std::size_t> chosen{}; ///< candidate chosen by the learner: an index into the candidates
};

/// Returns a value; nothing if the run has none, such as an advance before the first.
std::optional<double> valueOf(LessonValue value, const LessonState &state);

/// Returns true if a value, or one in the braces of a text, is known only in snapshots with their mesh.
bool needsMesh(LessonValue value);
bool needsMesh(std::string_view text);

/// Returns a text in which each {word} of a lesson value, in formulas \value{word}, is replaced by its number, or by
/// "–" if there is none.
std::string withValues(std::string_view text, const LessonState &state);

/// The relation that a condition demands.
enum class LessonRelation : std::uint8_t { Is, Above, Below };
template <>
struct EnumWords<LessonRelation> {
    static constexpr auto kLast = LessonRelation::Below;
    static constexpr std::array<std::string_view, 3> kList = {"is", "above", "below"};
};

/// A condition on the state of a run.
struct LessonCondition {
    LessonValue value = LessonValue::Advance;
    LessonRelation relation = LessonRelation::Is;
    double number = 0.0;
    std::optional<LessonValue> other{}; ///< compared with this value instead of `number`
    double within = 1e-9;               ///< Is: largest difference
};

/// Returns true if the state fulfils a condition; a value that the run does not have fulfils none.
bool holds(const LessonCondition &condition, const LessonState &state);

} // namespace forefront
