#pragma once

#include "core/spacing/parts/expression/expression_program.hpp"

#include <string_view>
#include <variant>
#include <vector>

namespace forefront {

/// Parses a formula into postfix order, not yet optimised; used by ExpressionProgram::compile.
std::variant<std::vector<ExpressionInstruction>, ExpressionFault> parseExpression(std::string_view text,
                                                                                  FormulaNames names);
/// Returns true if a formula gives the name a meaning of its own: a coordinate, a function or a constant.
bool isReservedName(std::string_view name);
/// Returns the names in a formula, in order, whether they are known or not. Each is a part of `text`.
std::vector<std::string_view> namesIn(std::string_view text);

} // namespace forefront
