#pragma once

#include "core/engine/base/result.hpp"
#include "core/teaching/lesson/lesson_value.hpp"
#include "core/teaching/lesson/random_numbers.hpp"

#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// A number of a question: a value of the run, a constant, or a formula of values such as "2*front - n", in which
/// random numbers have been replaced by theirs.
struct LessonFormula {
    std::string text;    ///< as the lesson has it
    std::string formula; ///< in the names v0, v1, ... of `values`
    std::vector<LessonValue> values;
};

/// Returns the formula of a value alone.
LessonFormula formulaOf(LessonValue value);
/// Returns the formula of a constant.
LessonFormula formulaOf(double constant);
/// Reads a formula of lesson values, random numbers and numbers, with the operators and functions of expressions. A
/// name with a hyphen, such as new-nodes, is the value wherever there is one; write spaces to subtract. Errors:
/// "bad-field", with what names are expected.
Result<LessonFormula> readFormula(const std::string &text, const RandomNumbers &numbers);

/// Returns the number of a formula in a state; nothing if one of its values has none there, or the result is not
/// finite.
std::optional<double> valueOf(const LessonFormula &formula, const LessonState &state);

} // namespace forefront
