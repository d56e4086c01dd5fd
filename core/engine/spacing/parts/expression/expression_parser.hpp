#pragma once

#include "core/engine/spacing/parts/expression/expression_program.hpp"

#include <string_view>
#include <variant>
#include <vector>

namespace forefront {

/// Parses a formula into postfix order, not yet optimised; used by ExpressionProgram::compile.
std::variant<std::vector<ExpressionInstruction>, ExpressionFault> parseExpression(std::string_view text,
                                                                                  FormulaNames names);
/// Returns true if the name has a fixed meaning in formulas: a coordinate, a function or a constant.
bool isReservedName(std::string_view name);
/// Returns the names in a formula, known or not, in order. They point into `text`.
std::vector<std::string_view> namesIn(std::string_view text);

} // namespace forefront
