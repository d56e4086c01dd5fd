#pragma once

#include "core/spacing/expression_program.hpp"

#include <cmath>

namespace forefront {

/// Number of stack entries an operation takes; every operation leaves one.
constexpr int operandCount(ExpressionOp op) {
    if (op <= ExpressionOp::Push) {
        return 0;
    }
    if (op == ExpressionOp::Select) {
        return 3;
    }
    return op <= ExpressionOp::Distance ? 2 : 1;
}

// As std::min and std::max, which muparser uses: where one operand is NaN, the first wins.
constexpr double lesser(double a, double b) {
    return b < a ? b : a;
}
constexpr double greater(double a, double b) {
    return a < b ? b : a;
}

/// Calls use(f) with f(a, b, p) the operation on two operands at the point p. One definition serves single and bulk
/// evaluation, so that both give the same doubles.
template <class Use>
auto withBinary(ExpressionOp op, Use use) {
    using Op = ExpressionOp;
    switch (op) {
    case Op::Add:
        return use([](double a, double b, Vec2) { return a + b; });
    case Op::Subtract:
        return use([](double a, double b, Vec2) { return a - b; });
    case Op::Multiply:
        return use([](double a, double b, Vec2) { return a * b; });
    case Op::Divide:
        return use([](double a, double b, Vec2) { return a / b; });
    case Op::Power:
        return use([](double a, double b, Vec2) { return std::pow(a, b); });
    case Op::Minimum:
        return use([](double a, double b, Vec2) { return lesser(a, b); });
    case Op::Maximum:
        return use([](double a, double b, Vec2) { return greater(a, b); });
    case Op::Less:
        return use([](double a, double b, Vec2) { return a < b ? 1.0 : 0.0; });
    case Op::LessEqual:
        return use([](double a, double b, Vec2) { return a <= b ? 1.0 : 0.0; });
    case Op::Greater:
        return use([](double a, double b, Vec2) { return a > b ? 1.0 : 0.0; });
    case Op::GreaterEqual:
        return use([](double a, double b, Vec2) { return a >= b ? 1.0 : 0.0; });
    case Op::Equal:
        return use([](double a, double b, Vec2) { return a == b ? 1.0 : 0.0; });
    case Op::NotEqual:
        return use([](double a, double b, Vec2) { return a != b ? 1.0 : 0.0; });
    case Op::And:
        return use([](double a, double b, Vec2) { return a != 0.0 && b != 0.0 ? 1.0 : 0.0; });
    case Op::Or:
        return use([](double a, double b, Vec2) { return a != 0.0 || b != 0.0 ? 1.0 : 0.0; });
    case Op::Arctangent2:
        return use([](double a, double b, Vec2) { return std::atan2(a, b); });
    case Op::Hypot:
        return use([](double a, double b, Vec2) { return std::sqrt(a * a + b * b); });
    default: // Distance
        return use([](double a, double b, Vec2 p) { return distance({a, b}, p); });
    }
}

/// Calls use(f) with f(a, k) the operation on one operand and the constant of the instruction.
template <class Use>
auto withUnary(ExpressionOp op, Use use) {
    using Op = ExpressionOp;
    switch (op) {
    case Op::AddBy:
        return use([](double a, double k) { return a + k; });
    case Op::SubtractBy:
        return use([](double a, double k) { return a - k; });
    case Op::SubtractFrom:
        return use([](double a, double k) { return k - a; });
    case Op::MultiplyBy:
        return use([](double a, double k) { return a * k; });
    case Op::DivideBy:
        return use([](double a, double k) { return a / k; });
    case Op::MinimumBy:
        return use([](double a, double k) { return lesser(a, k); });
    case Op::MaximumBy:
        return use([](double a, double k) { return greater(a, k); });
    case Op::MinimumOf:
        return use([](double a, double k) { return lesser(k, a); });
    case Op::MaximumOf:
        return use([](double a, double k) { return greater(k, a); });
    case Op::Negate:
        return use([](double a, double) { return -a; });
    case Op::Square:
        return use([](double a, double) { return a * a; });
    case Op::Cube:
        return use([](double a, double) { return a * a * a; });
    case Op::SquareRoot:
        return use([](double a, double) { return std::sqrt(a); });
    case Op::Absolute:
        return use([](double a, double) { return std::fabs(a); });
    case Op::Sign:
        return use([](double a, double) { return a < 0.0 ? -1.0 : (a > 0.0 ? 1.0 : 0.0); });
    case Op::Round:
        return use([](double a, double) { return std::floor(a + 0.5); });
    case Op::Sine:
        return use([](double a, double) { return std::sin(a); });
    case Op::Cosine:
        return use([](double a, double) { return std::cos(a); });
    case Op::Tangent:
        return use([](double a, double) { return std::tan(a); });
    case Op::Arcsine:
        return use([](double a, double) { return std::asin(a); });
    case Op::Arccosine:
        return use([](double a, double) { return std::acos(a); });
    case Op::Arctangent:
        return use([](double a, double) { return std::atan(a); });
    case Op::HyperbolicSine:
        return use([](double a, double) { return std::sinh(a); });
    case Op::HyperbolicCosine:
        return use([](double a, double) { return std::cosh(a); });
    case Op::HyperbolicTangent:
        return use([](double a, double) { return std::tanh(a); });
    case Op::AreaSine:
        return use([](double a, double) { return std::asinh(a); });
    case Op::AreaCosine:
        return use([](double a, double) { return std::acosh(a); });
    case Op::AreaTangent:
        return use([](double a, double) { return std::atanh(a); });
    case Op::Exponential:
        return use([](double a, double) { return std::exp(a); });
    case Op::Logarithm:
        return use([](double a, double) { return std::log(a); });
    case Op::Logarithm2:
        return use([](double a, double) { return std::log2(a); });
    default: // Logarithm10
        return use([](double a, double) { return std::log10(a); });
    }
}

} // namespace forefront
