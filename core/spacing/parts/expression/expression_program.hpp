#pragma once

#include "core/base/vec2.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace forefront {

/// Operations of the stack program. The forms ...By, ...Of and SubtractFrom take one operand from the
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
    AreaSine,
    AreaCosine,
    AreaTangent,
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

/// Interval of values; `undefined` where the formula may give no number (NaN) somewhere in the argument box.
struct ValueRange {
    double low = 0.0;
    double high = 0.0;
    bool undefined = false;
};

/// Where and why a formula cannot be compiled.
struct ExpressionFault {
    std::size_t column = 0; ///< zero-based
    std::string message;
};

/// A formula in x and y as a short stack program: immutable, so that many threads may evaluate it at once, and without
/// an indirect call per operation.
class ExpressionProgram {
  public:
    static constexpr std::size_t kDeepest = 48; ///< entries of the stack

    /// The grammar of muparser (operators, precedence, functions, ?:) without assignment and strings.
    static std::variant<ExpressionProgram, ExpressionFault> compile(std::string_view text);

    /// Value at p; NaN or infinite where the formula is.
    double evaluate(Vec2 p) const;
    /// The same doubles as evaluate(), point by point, several times faster.
    void evaluateMany(std::span<const Vec2> points, std::span<double> values) const;
    /// Bounds of the values over a box (interval arithmetic; rounding is covered by a margin of a few units in the
    /// last place).
    ValueRange range(const Box2 &box) const;

    std::span<const ExpressionInstruction> instructions() const { return code_; }

  private:
    std::vector<ExpressionInstruction> code_;
};

} // namespace forefront
