#include "core/engine/spacing/parts/expression/expression.hpp"

#include "core/engine/spacing/parts/expression/spacing_functions.hpp"

#include <cmath>
#include <variant>

namespace forefront {
namespace {

Diagnostics syntaxError(const std::string &message, std::size_t column, FormulaNames names) {
    const char *const advice =
        names.coordinates ? "write a formula in x and y such as max(0.1, 0.2*dist(3, 2)), with + - * / ^, min, max, "
                            "sqrt, abs, exp, ln, sin, atan2 and the like; dist(a, b) is the distance to (a, b)"
                          : "write a number such as 0.25, or a formula of parameters such as 2*r + 0.5";
    Diagnostics faults =
        error("expression-syntax", "expression, column " + std::to_string(column) + ": " + message, advice);
    faults.front().column = static_cast<int>(column);
    return faults;
}

Result<ExpressionProgram> compile(const std::string &text, FormulaNames names) {
    if (text.size() > kMaxExpressionLength) {
        return syntaxError(std::to_string(text.size()) + " characters; expected at most " +
                               std::to_string(kMaxExpressionLength),
                           kMaxExpressionLength + 1, names);
    }
    auto compiled = ExpressionProgram::compile(text, names);
    if (const auto *const fault = std::get_if<ExpressionFault>(&compiled)) {
        return syntaxError(fault->message, fault->column + 1, names);
    }
    return std::move(std::get<ExpressionProgram>(compiled));
}

} // namespace

Result<ExpressionProgram> compileExpression(const std::string &text, const NamedValues &names) {
    return compile(text, {.coordinates = true, .values = names.empty() ? nullptr : &names, .functions = nullptr});
}

Result<ExpressionProgram> compileSpacingExpression(const std::string &text, const SpacingSpec &spec,
                                                   const Domain *domain) {
    const SpacingFunctions functions(spec, domain);
    return compile(
        text, {.coordinates = true, .values = spec.names.empty() ? nullptr : &spec.names, .functions = &functions});
}

Result<double> evaluateExpression(const std::string &text, const NamedValues &names) {
    const Result<ExpressionProgram> program =
        compile(text, {.coordinates = false, .values = &names, .functions = nullptr});
    if (!program) {
        return program.faults();
    }
    const double value = program->evaluate({});
    if (!std::isfinite(value)) {
        return error("expression-value", "'" + text + "' is not a finite number",
                     "avoid division by zero, and roots and logarithms of negative numbers");
    }
    return value;
}

} // namespace forefront
