#include "core/engine/spacing/parts/expression/expression_program.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/spacing/parts/expression/expression_operations.hpp"
#include "core/engine/spacing/parts/expression/expression_parser.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace forefront {
namespace {

using Op = ExpressionOp;

/// Runs one instruction on a stack whose topmost entry is `top` and whose next is below[-1].
struct ScalarStep {
    double &top;
    double *&below;
    double constant;
    Vec2 p;
    std::span<const std::shared_ptr<const PlaneFunction>> functions;

    template <class F>
    void push(F f) {
        *below++ = top;
        top = f(p, constant);
    }
    template <class F>
    void unary(F f) {
        top = f(top, constant);
    }
    template <class F>
    void binary(F f) {
        --below;
        top = f(*below, top, p);
    }
    void call() {
        --below;
        top = functions[static_cast<std::size_t>(constant)]->at({*below, top});
    }
    void select() {
        below -= 2;
        top = below[0] != 0.0 ? below[1] : top;
    }
};

/// The same on a block of points, entry by entry; `top` points one past the topmost entry.
constexpr std::size_t kBlock = 32;
using Block = std::array<double, kBlock>;
struct BlockStep {
    Block *&top;
    double constant;
    std::span<const Vec2> points;
    std::span<const std::shared_ptr<const PlaneFunction>> functions;

    template <class F>
    void push(F f) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            (*top)[i] = f(points[i], constant);
        }
        ++top;
    }
    template <class F>
    void unary(F f) {
        double *const a = top[-1].data();
        for (std::size_t i = 0; i < points.size(); ++i) {
            a[i] = f(a[i], constant);
        }
    }
    template <class F>
    void binary(F f) {
        --top;
        double *const a = top[-1].data();
        const double *const b = top[0].data();
        for (std::size_t i = 0; i < points.size(); ++i) {
            a[i] = f(a[i], b[i], points[i]);
        }
    }
    void call() {
        --top;
        const PlaneFunction &function = *functions[static_cast<std::size_t>(constant)];
        for (std::size_t i = 0; i < points.size(); ++i) {
            top[-1][i] = function.at({top[-1][i], top[0][i]});
        }
    }
    void select() {
        top -= 2;
        for (std::size_t i = 0; i < points.size(); ++i) {
            top[-1][i] = top[-1][i] != 0.0 ? top[0][i] : top[1][i];
        }
    }
};

double applyUnary(const ExpressionInstruction &instruction, double a) {
    double *below = nullptr;
    dispatch(instruction.op, ScalarStep{a, below, instruction.constant, {}, {}});
    return a;
}
double applyBinary(Op op, double a, double b) {
    double *below = &a + 1;
    dispatch(op, ScalarStep{b, below, 0.0, {}, {}});
    return b;
}

/// Returns the form of a binary operation with a constant second operand, if one gives the same doubles.
std::optional<Op> withConstantSecond(Op op, double constant) {
    switch (op) {
    case Op::Add:
        return Op::AddBy;
    case Op::Subtract:
        return Op::SubtractBy;
    case Op::Multiply:
        return Op::MultiplyBy;
    case Op::Divide:
        return Op::DivideBy;
    case Op::Minimum:
        return Op::MinimumBy;
    case Op::Maximum:
        return Op::MaximumBy;
    case Op::Power:
        if (constant == 2.0) {
            return Op::Square;
        }
        return constant == 3.0 ? std::optional(Op::Cube) : std::nullopt;
    default:
        return std::nullopt;
    }
}
std::optional<Op> withConstantFirst(Op op) {
    switch (op) {
    case Op::Add:
        return Op::AddBy;
    case Op::Subtract:
        return Op::SubtractFrom;
    case Op::Multiply:
        return Op::MultiplyBy;
    case Op::Minimum:
        return Op::MinimumOf;
    case Op::Maximum:
        return Op::MaximumOf;
    default:
        return std::nullopt;
    }
}

/// Folds constants and gives operations their constant operands.
class Optimiser {
  public:
    std::vector<ExpressionInstruction> run(const std::vector<ExpressionInstruction> &source) {
        for (const ExpressionInstruction &instruction : source) {
            switch (operandCount(instruction.op)) {
            case 0:
                begins_.push_back(code_.size());
                code_.push_back(instruction);
                break;
            case 1:
                addUnary(instruction);
                break;
            case 2:
                addBinary(instruction);
                break;
            default:
                begins_.resize(begins_.size() - 2);
                code_.push_back(instruction);
            }
        }
        return std::move(code_);
    }

  private:
    bool isConstant(std::size_t begin, std::size_t end) const {
        return end == begin + 1 && code_[begin].op == Op::Push;
    }
    void addUnary(const ExpressionInstruction &instruction) {
        if (isConstant(begins_.back(), code_.size())) {
            code_.back().constant = applyUnary(instruction, code_.back().constant);
        } else if (!(instruction.op == Op::SquareRoot && foldDistance())) {
            code_.push_back(instruction);
        }
    }

    /// If the code ends with the square of x or y, of x − k or of x + k, removes that end and returns k.
    static std::optional<double> takeSquare(std::vector<ExpressionInstruction> &code, Op coordinate) {
        if (code.size() < 2 || code.back().op != Op::Square) {
            return std::nullopt;
        }
        std::size_t at = code.size() - 2;
        double centre = 0.0;
        if (code[at].op == Op::SubtractBy || code[at].op == Op::AddBy) {
            centre = code[at].op == Op::SubtractBy ? code[at].constant : -code[at].constant;
            if (at-- == 0) {
                return std::nullopt;
            }
        }
        if (code[at].op != coordinate) {
            return std::nullopt;
        }
        code.resize(at);
        return centre;
    }

    /// Replaces the root of (x − a)² + (y − b)² by the distance to (a, b), which gives the same doubles.
    bool foldDistance() {
        if (code_.back().op != Op::Add) {
            return false;
        }
        std::vector<ExpressionInstruction> rest(code_.begin(), code_.end() - 1);
        const auto b = takeSquare(rest, Op::PushY);
        const auto a = b ? takeSquare(rest, Op::PushX) : std::nullopt;
        if (!a) {
            return false;
        }
        code_ = std::move(rest);
        code_.insert(code_.end(), {{Op::Push, *a}, {Op::Push, *b}, {Op::Distance, 0.0}});
        return true;
    }
    void addBinary(const ExpressionInstruction &instruction) {
        const Op op = instruction.op;
        const std::size_t second = begins_.back();
        begins_.pop_back();
        const std::size_t first = begins_.back();
        const bool secondConstant = isConstant(second, code_.size());
        const bool firstConstant = isConstant(first, second);
        if (firstConstant && secondConstant && op != Op::Distance && op != Op::Call) {
            const double value = applyBinary(op, code_[first].constant, code_[second].constant);
            code_.resize(first);
            code_.push_back({Op::Push, value});
            return;
        }
        if (const auto form = secondConstant ? withConstantSecond(op, code_[second].constant) : std::nullopt) {
            code_.back() = {*form, code_[second].constant};
            return;
        }
        if (const auto form = firstConstant ? withConstantFirst(op) : std::nullopt) {
            const double constant = code_[first].constant;
            code_.erase(code_.begin() + static_cast<std::ptrdiff_t>(first));
            code_.push_back({*form, constant});
            return;
        }
        code_.push_back(instruction);
    }

    std::vector<ExpressionInstruction> code_;
    std::vector<std::size_t> begins_; ///< where the code of each stack entry starts
};

std::size_t stackNeeded(const std::vector<ExpressionInstruction> &code) {
    std::size_t entries = 0;
    std::size_t maximum = 0;
    for (const ExpressionInstruction &instruction : code) {
        entries += 1;
        entries -= static_cast<std::size_t>(operandCount(instruction.op));
        maximum = std::max(maximum, entries);
    }
    return maximum;
}

} // namespace

std::variant<ExpressionProgram, ExpressionFault> ExpressionProgram::compile(std::string_view text, FormulaNames names) {
    auto parsed = parseExpression(text, names);
    if (auto *fault = std::get_if<ExpressionFault>(&parsed)) {
        return std::move(*fault);
    }
    ExpressionProgram program;
    auto &[code, functions] = std::get<ParsedExpression>(parsed);
    program.code_ = Optimiser().run(code);
    program.functions_ = std::move(functions);
    if (stackNeeded(program.code_) > kMaxDepth) {
        return ExpressionFault{0, "nested too deeply; expected at most " + std::to_string(kMaxDepth) +
                                      " intermediate values"};
    }
    return program;
}

double ExpressionProgram::evaluate(Vec2 p) const {
    std::array<double, kMaxDepth + 1> stack; // [0]: pushed away by the first operand
    double *below = stack.data();
    double top = 0.0;
    for (const ExpressionInstruction &instruction : code_) {
        dispatch(instruction.op, ScalarStep{top, below, instruction.constant, p, functions_});
    }
    return top;
}

void ExpressionProgram::evaluateMany(std::span<const Vec2> points, std::span<double> values) const {
    FOREFRONT_ASSERT(points.size() == values.size());
    std::array<Block, kMaxDepth> stack;
    for (std::size_t begin = 0; begin < points.size(); begin += kBlock) {
        const auto part = points.subspan(begin, std::min(kBlock, points.size() - begin));
        Block *top = stack.data();
        for (const ExpressionInstruction &instruction : code_) {
            dispatch(instruction.op, BlockStep{top, instruction.constant, part, functions_});
        }
        std::copy_n(stack[0].begin(), part.size(), values.begin() + static_cast<std::ptrdiff_t>(begin));
    }
}

} // namespace forefront
