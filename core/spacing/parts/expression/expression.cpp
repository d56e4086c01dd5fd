#include "core/spacing/parts/expression/expression.hpp"

namespace forefront {
namespace {

constexpr std::size_t kMaxLength = 4000; ///< characters; keeps parsing fast for any pasted text

Diagnostics syntaxError(const std::string &message, std::size_t column) {
    Diagnostics faults = error("expression-syntax", "expression, column " + std::to_string(column) + ": " + message,
                               "write a formula in x and y such as max(0.1, 0.2*dist(3, 2)), with + - * / ^, min, max, "
                               "sqrt, abs, exp, ln, sin, atan2 and the like; dist(a, b) is the distance to (a, b)");
    faults.front().column = static_cast<int>(column);
    return faults;
}

} // namespace

Result<ExpressionProgram> compileExpression(const std::string &text) {
    if (text.size() > kMaxLength) {
        return syntaxError(std::to_string(text.size()) + " characters; expected at most " + std::to_string(kMaxLength),
                           kMaxLength + 1);
    }
    auto compiled = ExpressionProgram::compile(text);
    if (const auto *const fault = std::get_if<ExpressionFault>(&compiled)) {
        return syntaxError(fault->message, fault->column + 1);
    }
    return std::move(std::get<ExpressionProgram>(compiled));
}

} // namespace forefront
