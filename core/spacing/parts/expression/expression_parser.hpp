#pragma once

#include "core/spacing/parts/expression/expression_program.hpp"

#include <variant>
#include <vector>

namespace forefront {

/// A formula in postfix order before optimisation; used by ExpressionProgram::compile.
std::variant<std::vector<ExpressionInstruction>, ExpressionFault> parseExpression(std::string_view text);

} // namespace forefront
