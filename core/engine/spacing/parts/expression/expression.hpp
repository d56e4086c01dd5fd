#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/parts/expression/expression_program.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"

#include <cstddef>
#include <string>

namespace forefront {

/// Maximum length of an expression in characters, which keeps parsing fast for any pasted text.
inline constexpr std::size_t kMaxExpressionLength = 4000;

/// Compiles an expression in x, y and the given names.
///
/// Operators by increasing precedence: ?: (choice), ||, &&, < <= > >= == !=, + -, * /, sign, ^ (power,
/// right-associative). Functions: sqrt abs sign rint exp ln log (natural) log2 log10, sin cos tan asin acos atan
/// (radians) atan2(y, x) sinh cosh tanh asinh acosh atanh, min max sum avg (any number of arguments), pow(a, b),
/// hypot(a, b), dist(x0, y0): the distance from (x, y) to the point (x0, y0). Constants: pi, e (also _pi, _e).
///
/// Errors: expression-syntax, with `column` (1-based) in the text.
Result<ExpressionProgram> compileExpression(const std::string &text, const NamedValues &names = {});

/// Compiles the expression of a spacing in x, y and its names, which may also call its rasters and shore(x, y); see
/// SpacingFunctions. Without a domain it is only checked, must not be evaluated, and any boundary part is accepted.
/// Errors: expression-syntax, with `column`; also that of a boundary part that the domain does not have.
Result<ExpressionProgram> compileSpacingExpression(const std::string &text, const SpacingSpec &spec,
                                                   const Domain *domain);

/// Returns the value of an expression in the given names but not x and y, such as 2*r + 0.5. Errors: expression-syntax,
/// with `column`; expression-value if it is not finite.
Result<double> evaluateExpression(const std::string &text, const NamedValues &names);

} // namespace forefront
