#pragma once

#include "core/engine/spacing/parts/expression/expression_program.hpp"

#include <cmath>

namespace forefront {

/// Returns the number of stack entries that an operation consumes; every operation leaves one.
constexpr int operandCount(ExpressionOp op) {
    if (op <= ExpressionOp::Push) {
        return 0;
    }
    if (op == ExpressionOp::Select) {
        return 3;
    }
    return op <= ExpressionOp::Call ? 2 : 1;
}

// Work like std::min and std::max, which muparser uses: if one operand is NaN, the first wins.
constexpr double lesser(double a, double b) {
    return b < a ? b : a;
}
constexpr double greater(double a, double b) {
    return a < b ? b : a;
}

/// Dispatches an operation with one jump: calls on.push(f) with f(p, k), on.unary(f) with f(a, k), on.binary(f) with
/// f(a, b, p), on.call() or on.select(), k being the constant of the instruction. One definition serves single and bulk
/// evaluation, so that both give the same doubles.
template <class On>
inline void dispatch(ExpressionOp op, On &&on) {
    using Op = ExpressionOp;
    switch (op) {
    case Op::PushX:
        return on.push([](Vec2 p, double) { return p.x; });
    case Op::PushY:
        return on.push([](Vec2 p, double) { return p.y; });
    case Op::Push:
        return on.push([](Vec2, double k) { return k; });
    case Op::Add:
        return on.binary([](double a, double b, Vec2) { return a + b; });
    case Op::Subtract:
        return on.binary([](double a, double b, Vec2) { return a - b; });
    case Op::Multiply:
        return on.binary([](double a, double b, Vec2) { return a * b; });
    case Op::Divide:
        return on.binary([](double a, double b, Vec2) { return a / b; });
    case Op::Power:
        return on.binary([](double a, double b, Vec2) { return std::pow(a, b); });
    case Op::Minimum:
        return on.binary([](double a, double b, Vec2) { return lesser(a, b); });
    case Op::Maximum:
        return on.binary([](double a, double b, Vec2) { return greater(a, b); });
    case Op::Less:
        return on.binary([](double a, double b, Vec2) { return a < b ? 1.0 : 0.0; });
    case Op::LessEqual:
        return on.binary([](double a, double b, Vec2) { return a <= b ? 1.0 : 0.0; });
    case Op::Greater:
        return on.binary([](double a, double b, Vec2) { return a > b ? 1.0 : 0.0; });
    case Op::GreaterEqual:
        return on.binary([](double a, double b, Vec2) { return a >= b ? 1.0 : 0.0; });
    case Op::Equal:
        return on.binary([](double a, double b, Vec2) { return a == b ? 1.0 : 0.0; });
    case Op::NotEqual:
        return on.binary([](double a, double b, Vec2) { return a != b ? 1.0 : 0.0; });
    case Op::And:
        return on.binary([](double a, double b, Vec2) { return a != 0.0 && b != 0.0 ? 1.0 : 0.0; });
    case Op::Or:
        return on.binary([](double a, double b, Vec2) { return a != 0.0 || b != 0.0 ? 1.0 : 0.0; });
    case Op::Arctangent2:
        return on.binary([](double a, double b, Vec2) { return std::atan2(a, b); });
    case Op::Hypot:
        return on.binary([](double a, double b, Vec2) { return std::sqrt(a * a + b * b); });
    case Op::Distance:
        return on.binary(
            [](double a, double b, Vec2 p) { return std::sqrt((p.x - a) * (p.x - a) + (p.y - b) * (p.y - b)); });
    case Op::Call:
        return on.call();
    case Op::AddBy:
        return on.unary([](double a, double k) { return a + k; });
    case Op::SubtractBy:
        return on.unary([](double a, double k) { return a - k; });
    case Op::SubtractFrom:
        return on.unary([](double a, double k) { return k - a; });
    case Op::MultiplyBy:
        return on.unary([](double a, double k) { return a * k; });
    case Op::DivideBy:
        return on.unary([](double a, double k) { return a / k; });
    case Op::MinimumBy:
        return on.unary([](double a, double k) { return lesser(a, k); });
    case Op::MaximumBy:
        return on.unary([](double a, double k) { return greater(a, k); });
    case Op::MinimumOf:
        return on.unary([](double a, double k) { return lesser(k, a); });
    case Op::MaximumOf:
        return on.unary([](double a, double k) { return greater(k, a); });
    case Op::Negate:
        return on.unary([](double a, double) { return -a; });
    case Op::Square:
        return on.unary([](double a, double) { return a * a; });
    case Op::Cube:
        return on.unary([](double a, double) { return a * a * a; });
    case Op::SquareRoot:
        return on.unary([](double a, double) { return std::sqrt(a); });
    case Op::Absolute:
        return on.unary([](double a, double) { return std::fabs(a); });
    case Op::Sign:
        return on.unary([](double a, double) { return a < 0.0 ? -1.0 : (a > 0.0 ? 1.0 : 0.0); });
    case Op::Round:
        return on.unary([](double a, double) { return std::floor(a + 0.5); });
    case Op::Sine:
        return on.unary([](double a, double) { return std::sin(a); });
    case Op::Cosine:
        return on.unary([](double a, double) { return std::cos(a); });
    case Op::Tangent:
        return on.unary([](double a, double) { return std::tan(a); });
    case Op::Arcsine:
        return on.unary([](double a, double) { return std::asin(a); });
    case Op::Arccosine:
        return on.unary([](double a, double) { return std::acos(a); });
    case Op::Arctangent:
        return on.unary([](double a, double) { return std::atan(a); });
    case Op::HyperbolicSine:
        return on.unary([](double a, double) { return std::sinh(a); });
    case Op::HyperbolicCosine:
        return on.unary([](double a, double) { return std::cosh(a); });
    case Op::HyperbolicTangent:
        return on.unary([](double a, double) { return std::tanh(a); });
    case Op::InverseSinh:
        return on.unary([](double a, double) { return std::asinh(a); });
    case Op::InverseCosh:
        return on.unary([](double a, double) { return std::acosh(a); });
    case Op::InverseTanh:
        return on.unary([](double a, double) { return std::atanh(a); });
    case Op::Exponential:
        return on.unary([](double a, double) { return std::exp(a); });
    case Op::Logarithm:
        return on.unary([](double a, double) { return std::log(a); });
    case Op::Logarithm2:
        return on.unary([](double a, double) { return std::log2(a); });
    case Op::Logarithm10:
        return on.unary([](double a, double) { return std::log10(a); });
    case Op::Select:
        return on.select();
    }
}

} // namespace forefront
