#pragma once

#include "core/engine/spacing/parts/expression/expression_program.hpp"

#include <memory>
#include <string_view>
#include <variant>
#include <vector>

namespace forefront {

/// A formula in postfix order, not yet optimised.
struct ParsedExpression {
    std::vector<ExpressionInstruction> code;
    std::vector<std::shared_ptr<const PlaneFunction>> functions; ///< one per Call, at the index in its constant
};

/// Parses a formula; used by ExpressionProgram::compile.
std::variant<ParsedExpression, ExpressionFault> parseExpression(std::string_view text, FormulaNames names);
/// Returns true if the name has a fixed meaning in formulas: a coordinate, a function or a constant.
bool isReservedName(std::string_view name);
/// Returns the names in a formula, known or not, in order, without those in quotes. They point into `text`.
std::vector<std::string_view> namesIn(std::string_view text);

} // namespace forefront
