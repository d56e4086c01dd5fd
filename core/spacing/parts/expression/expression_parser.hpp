#pragma once

#include "core/spacing/parts/expression/expression_program.hpp"

#include <variant>
#include <vector>

namespace forefront {

/// Parses a formula into postfix order, not yet optimised; used by ExpressionProgram::compile.
std::variant<std::vector<ExpressionInstruction>, ExpressionFault> parseExpression(std::string_view text);

} // namespace forefront
