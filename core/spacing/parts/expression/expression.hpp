#pragma once

#include "core/base/result.hpp"
#include "core/spacing/parts/expression/expression_program.hpp"

#include <string>

namespace forefront {

/// Compiles an expression in x and y.
///
/// Operators by increasing precedence: ?: (choice), ||, &&, < <= > >= == !=, + -, * /, sign, ^ (power,
/// right-associative). Functions: sqrt abs sign rint exp ln log (natural) log2 log10, sin cos tan asin acos atan
/// (radians) atan2(y, x) sinh cosh tanh asinh acosh atanh, min max sum avg (any number of arguments), pow(a, b),
/// hypot(a, b), dist(x0, y0): the distance from (x, y) to the point (x0, y0). Constants: pi, e (also _pi, _e).
///
/// Errors: expression-syntax, with `column` (1-based) in the text.
Result<ExpressionProgram> compileExpression(const std::string &text);

} // namespace forefront
