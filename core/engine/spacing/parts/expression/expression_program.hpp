#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/spacing/parts/expression/plane_function.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace forefront {

/// The operations of the stack program. The forms ...By, ...Of and SubtractFrom take one operand from the
/// instruction.
enum class ExpressionOp : std::uint8_t {
    PushX,
    PushY,
    Push,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Minimum,
    Maximum,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
    Arctangent2,
    Hypot,
    Distance, ///< of (x, y) from the point in the two topmost entries
    Call,     ///< of the function with the index in the constant, at the point in the two topmost entries
    AddBy,
    SubtractBy,
    SubtractFrom, ///< constant − top
    MultiplyBy,
    DivideBy,
    MinimumBy,
    MaximumBy,
    MinimumOf, ///< the constant is the first operand: with NaN the first operand wins
    MaximumOf,
    Negate,
    Square,
    Cube,
    SquareRoot,
    Absolute,
    Sign,
    Round,
    Sine,
    Cosine,
    Tangent,
    Arcsine,
    Arccosine,
    Arctangent,
    HyperbolicSine,
    HyperbolicCosine,
    HyperbolicTangent,
    InverseSinh,
    InverseCosh,
    InverseTanh,
    Exponential,
    Logarithm,
    Logarithm2,
    Logarithm10,
    Select ///< three topmost entries: condition, value if true, value if false
};

struct ExpressionInstruction {
    ExpressionOp op = ExpressionOp::Push;
    double constant = 0.0;
};

/// An interval of values; `undefined` if the formula may be NaN somewhere in the argument box.
struct ValueRange {
    double low = 0.0;
    double high = 0.0;
    bool undefined = false;
};

/// The place and reason why a formula cannot be compiled.
struct ExpressionFault {
    std::size_t column = 0; ///< zero-based
    std::string message;
};

/// Names with values, such as the parameters of a document.
using NamedValues = std::map<std::string, double, std::less<>>;

/// The names that a formula may use besides functions and constants.
struct FormulaNames {
    bool coordinates = true;                     ///< x and y are allowed
    const NamedValues *values = nullptr;         ///< null: none
    const FormulaFunctions *functions = nullptr; ///< functions of the position besides the usual ones; null: none
};

/// A formula in x and y as a short stack program. Immutable, so threads may share it, and evaluated without an indirect
/// call per operation.
class ExpressionProgram {
  public:
    static constexpr std::size_t kMaxDepth = 48; ///< entries on the stack

    /// Compiles a formula in the grammar of muParser (operators, precedence, functions, ?:) without assignment and
    /// strings.
    static std::variant<ExpressionProgram, ExpressionFault> compile(std::string_view text, FormulaNames names = {});

    /// Returns the value at p; NaN or infinite where the formula is.
    double evaluate(Vec2 p) const;
    /// Computes the same doubles as evaluate() for many points, several times faster.
    void evaluateMany(std::span<const Vec2> points, std::span<double> values) const;
    /// Returns bounds of the values over a box by interval arithmetic, with a margin of a few units in the last place
    /// for rounding.
    ValueRange range(const Box2 &box) const;

    /// Returns the functions of the position that the formula calls.
    std::span<const std::shared_ptr<const PlaneFunction>> functions() const { return functions_; }

  private:
    std::vector<ExpressionInstruction> code_;
    std::vector<std::shared_ptr<const PlaneFunction>> functions_;
};

} // namespace forefront
