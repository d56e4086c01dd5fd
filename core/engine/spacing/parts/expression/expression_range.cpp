#include "core/engine/spacing/parts/expression/expression_operations.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <numbers>

namespace forefront {
namespace {

using Op = ExpressionOp;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Returns bounds from the values at the corners of a monotone operation, widened by a few units in the last place.
ValueRange hull(std::initializer_list<double> values, bool undefined) {
    ValueRange range{kInfinite, -kInfinite, undefined};
    for (const double value : values) {
        if (std::isnan(value)) {
            return {-kInfinite, kInfinite, true};
        }
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
    }
    constexpr double kMargin = 4e-15;
    range.low -= std::isfinite(range.low) ? kMargin * std::fabs(range.low) : 0.0;
    range.high += std::isfinite(range.high) ? kMargin * std::fabs(range.high) : 0.0;
    return range;
}
ValueRange anything(bool undefined) {
    return {-kInfinite, kInfinite, undefined};
}
ValueRange between(double low, double high, bool undefined) {
    return {low, high, undefined};
}

ValueRange product(const ValueRange &a, const ValueRange &b, bool undefined) {
    // 0 · ∞ can only come from ranges, not from values, unless a value is infinite itself: then nothing is known.
    return hull({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high}, undefined);
}
ValueRange quotient(const ValueRange &a, const ValueRange &b, bool undefined) {
    if (b.low <= 0.0 && b.high >= 0.0) {
        return anything(undefined || (a.low <= 0.0 && a.high >= 0.0));
    }
    return hull({a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high}, undefined);
}
ValueRange square(const ValueRange &a) {
    const double low = a.low > 0.0 ? a.low : (a.high < 0.0 ? a.high : 0.0);
    return hull({low * low, std::max(a.low * a.low, a.high * a.high)}, a.undefined);
}
ValueRange power(const ValueRange &a, const ValueRange &b, bool undefined) {
    if (a.low > 0.0) { // monotone in each argument
        return hull(
            {std::pow(a.low, b.low), std::pow(a.low, b.high), std::pow(a.high, b.low), std::pow(a.high, b.high)},
            undefined);
    }
    if (b.low == b.high && b.low > 0.0 && b.low == std::floor(b.low)) {
        const double low = std::pow(a.low, b.low);
        const double high = std::pow(a.high, b.low);
        return a.high >= 0.0 ? hull({low, high, 0.0}, undefined) : hull({low, high}, undefined);
    }
    return anything(true);
}
ValueRange truth(bool certainlyTrue, bool certainlyFalse, bool undefined) {
    return {certainlyTrue ? 1.0 : 0.0, certainlyFalse ? 0.0 : 1.0, undefined};
}
ValueRange wave(const ValueRange &a, double crest) {
    // Maxima of the wave at crest + 2πk, minima half a turn later.
    if (!std::isfinite(a.low) || !std::isfinite(a.high)) {
        return {-1.0, 1.0, true};
    }
    constexpr double turn = 2.0 * std::numbers::pi;
    const auto holds = [&](double place) {
        return std::floor((a.high - place) / turn + 1e-9) >= std::ceil((a.low - place) / turn - 1e-9);
    };
    const double p = std::cos(a.low - crest);
    const double q = std::cos(a.high - crest);
    ValueRange range = hull({p, q}, a.undefined);
    range.low = holds(crest + std::numbers::pi) ? -1.0 : range.low - 1e-12;
    range.high = holds(crest) ? 1.0 : range.high + 1e-12;
    return range;
}
ValueRange magnitude(const ValueRange &a) {
    const double high = std::max(std::fabs(a.low), std::fabs(a.high));
    return {a.low > 0.0 ? a.low : (a.high < 0.0 ? -a.high : 0.0), high, a.undefined};
}
ValueRange root(const ValueRange &a) {
    if (a.high < 0.0) {
        return anything(true);
    }
    return hull({std::sqrt(std::max(0.0, a.low)), std::sqrt(a.high)}, a.undefined || a.low < 0.0);
}

ValueRange binaryRange(Op op, const ValueRange &a, const ValueRange &b, const Box2 &box) {
    const bool undefined = a.undefined || b.undefined;
    switch (op) {
    case Op::Add:
        return hull({a.low + b.low, a.high + b.high}, undefined);
    case Op::Subtract:
        return hull({a.low - b.high, a.high - b.low}, undefined);
    case Op::Multiply:
        return product(a, b, undefined);
    case Op::Divide:
        return quotient(a, b, undefined);
    case Op::Power:
        return power(a, b, undefined);
    case Op::Minimum:
        return {std::min(a.low, b.low), std::min(a.high, b.high), undefined};
    case Op::Maximum:
        return {std::max(a.low, b.low), std::max(a.high, b.high), undefined};
    case Op::Less:
        return truth(a.high < b.low, a.low >= b.high, undefined);
    case Op::LessEqual:
        return truth(a.high <= b.low, a.low > b.high, undefined);
    case Op::Greater:
        return truth(a.low > b.high, a.high <= b.low, undefined);
    case Op::GreaterEqual:
        return truth(a.low >= b.high, a.high < b.low, undefined);
    case Op::Hypot:
        return root(binaryRange(Op::Add, square(a), square(b), box));
    case Op::Distance: {
        const ValueRange x = binaryRange(Op::Subtract, {box.min.x, box.max.x, false}, a, box);
        const ValueRange y = binaryRange(Op::Subtract, {box.min.y, box.max.y, false}, b, box);
        return root(binaryRange(Op::Add, square(x), square(y), box));
    }
    case Op::Arctangent2:
        return between(-std::numbers::pi - 1e-12, std::numbers::pi + 1e-12, undefined);
    default: // ==, !=, &&, ||
        return between(0.0, 1.0, undefined);
    }
}

/// A unary operation on one value.
struct UnaryOn {
    double value;
    double constant;
    template <class F>
    void push(F) {}
    template <class F>
    void unary(F f) {
        value = f(value, constant);
    }
    template <class F>
    void binary(F) {}
    void call() {}
    void select() {}
};
double applied(const ExpressionInstruction &instruction, double value) {
    UnaryOn on{value, instruction.constant};
    dispatch(instruction.op, on);
    return on.value;
}

ValueRange unaryRange(const ExpressionInstruction &instruction, const ValueRange &a, const Box2 &box) {
    const ValueRange k{instruction.constant, instruction.constant, std::isnan(instruction.constant)};
    switch (instruction.op) {
    case Op::AddBy:
        return binaryRange(Op::Add, a, k, box);
    case Op::SubtractBy:
        return binaryRange(Op::Subtract, a, k, box);
    case Op::SubtractFrom:
        return binaryRange(Op::Subtract, k, a, box);
    case Op::MultiplyBy:
        return binaryRange(Op::Multiply, a, k, box);
    case Op::DivideBy:
        return binaryRange(Op::Divide, a, k, box);
    case Op::MinimumBy:
        return binaryRange(Op::Minimum, a, k, box);
    case Op::MaximumBy:
        return binaryRange(Op::Maximum, a, k, box);
    case Op::MinimumOf: // without a number the constant wins
        return {std::min(a.low, k.low), k.high, k.undefined || a.undefined};
    case Op::MaximumOf:
        return {std::max(a.low, k.low), std::max(a.high, k.high), k.undefined || a.undefined};
    case Op::Negate:
        return {-a.high, -a.low, a.undefined};
    case Op::Square:
        return square(a);
    case Op::SquareRoot:
        return root(a);
    case Op::Absolute:
        return magnitude(a);
    case Op::Sine:
        return wave(a, 0.5 * std::numbers::pi);
    case Op::Cosine:
        return wave(a, 0.0);
    case Op::Logarithm:
    case Op::Logarithm2:
    case Op::Logarithm10:
        if (a.low <= 0.0) {
            return anything(a.undefined || a.low < 0.0);
        }
        break;
    case Op::Tangent:
    case Op::HyperbolicCosine:
    case Op::Arcsine:
    case Op::Arccosine:
    case Op::InverseCosh:
    case Op::InverseTanh:
        return anything(true);
    default:
        break;
    }
    // The rest grows with its argument.
    return hull({applied(instruction, a.low), applied(instruction, a.high)}, a.undefined);
}

} // namespace

ValueRange ExpressionProgram::range(const Box2 &box) const {
    std::array<ValueRange, kMaxDepth + 3> stack;
    std::size_t top = 0; // number of entries
    for (const ExpressionInstruction &instruction : code_) {
        const Op op = instruction.op;
        if (op == Op::PushX) {
            stack[top++] = {box.min.x, box.max.x, false};
        } else if (op == Op::PushY) {
            stack[top++] = {box.min.y, box.max.y, false};
        } else if (op == Op::Push) {
            stack[top++] = {instruction.constant, instruction.constant, std::isnan(instruction.constant)};
        } else if (op == Op::Select) {
            top -= 2;
            const ValueRange &condition = stack[top - 1];
            const ValueRange yes = stack[top];
            const ValueRange no = stack[top + 1];
            const bool mayYes = condition.low != 0.0 || condition.high != 0.0;
            const bool mayNo = condition.low <= 0.0 && condition.high >= 0.0;
            const bool undefined = condition.undefined || (mayYes && yes.undefined) || (mayNo && no.undefined);
            stack[top - 1] = mayYes && mayNo
                                 ? ValueRange{std::min(yes.low, no.low), std::max(yes.high, no.high), undefined}
                             : mayYes ? ValueRange{yes.low, yes.high, undefined}
                                      : ValueRange{no.low, no.high, undefined};
        } else if (op == Op::Call) {
            --top;
            const ValueRange &x = stack[top - 1], &y = stack[top];
            const auto &function = functions_[static_cast<std::size_t>(instruction.constant)];
            const ValueRange values = function->range({{x.low, y.low}, {x.high, y.high}});
            stack[top - 1] = {values.low, values.high, values.undefined || x.undefined || y.undefined};
        } else if (operandCount(op) == 2) {
            --top;
            stack[top - 1] = binaryRange(op, stack[top - 1], stack[top], box);
        } else {
            stack[top - 1] = unaryRange(instruction, stack[top - 1], box);
        }
    }
    return stack[0];
}

} // namespace forefront
