#include "core/engine/spacing/parts/expression/expression_parser.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace forefront {
namespace {

struct NamedConstant {
    std::string_view name;
    double value;
};
constexpr std::array<NamedConstant, 4> kConstants{
    {{"pi", std::numbers::pi}, {"_pi", std::numbers::pi}, {"e", std::numbers::e}, {"_e", std::numbers::e}}};

struct NamedFunction {
    std::string_view name;
    ExpressionOp op;
    int arguments;     ///< number; -1: one or more, folded from the left with `op`
    bool mean = false; ///< divide the folded value by the number of arguments
};
constexpr std::array<NamedFunction, 29> kFunctions{{{"sin", ExpressionOp::Sine, 1},
                                                    {"cos", ExpressionOp::Cosine, 1},
                                                    {"tan", ExpressionOp::Tangent, 1},
                                                    {"asin", ExpressionOp::Arcsine, 1},
                                                    {"acos", ExpressionOp::Arccosine, 1},
                                                    {"atan", ExpressionOp::Arctangent, 1},
                                                    {"atan2", ExpressionOp::Arctangent2, 2},
                                                    {"sinh", ExpressionOp::HyperbolicSine, 1},
                                                    {"cosh", ExpressionOp::HyperbolicCosine, 1},
                                                    {"tanh", ExpressionOp::HyperbolicTangent, 1},
                                                    {"asinh", ExpressionOp::InverseSinh, 1},
                                                    {"acosh", ExpressionOp::InverseCosh, 1},
                                                    {"atanh", ExpressionOp::InverseTanh, 1},
                                                    {"exp", ExpressionOp::Exponential, 1},
                                                    {"ln", ExpressionOp::Logarithm, 1},
                                                    {"log", ExpressionOp::Logarithm, 1},
                                                    {"log2", ExpressionOp::Logarithm2, 1},
                                                    {"log10", ExpressionOp::Logarithm10, 1},
                                                    {"sqrt", ExpressionOp::SquareRoot, 1},
                                                    {"abs", ExpressionOp::Absolute, 1},
                                                    {"sign", ExpressionOp::Sign, 1},
                                                    {"rint", ExpressionOp::Round, 1},
                                                    {"hypot", ExpressionOp::Hypot, 2},
                                                    {"dist", ExpressionOp::Distance, 2},
                                                    {"min", ExpressionOp::Minimum, -1},
                                                    {"max", ExpressionOp::Maximum, -1},
                                                    {"sum", ExpressionOp::Add, -1},
                                                    {"avg", ExpressionOp::Add, -1, true},
                                                    {"pow", ExpressionOp::Power, 2}}};

constexpr int kMaxNesting = 200;

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
bool isNameStart(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool isCoordinate(std::string_view name) {
    return name == "x" || name == "y";
}

/// Returns the UTF-8 character at the start of a text, which need not be well-formed.
std::string_view firstCharacter(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text.front());
    const std::size_t length = lead < 0xc2 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 1;
    std::size_t end = 1;
    while (end < std::min(length, text.size()) && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) {
        ++end;
    }
    return text.substr(0, end == length ? end : 1);
}

/// Quotes the character at the start of a text, or names the byte if it is not printable.
std::string quoted(std::string_view text) {
    const std::string_view character = firstCharacter(text);
    const char c = character.front();
    return character.size() > 1 || (c >= ' ' && c <= '~') ? "'" + std::string(character) + "'"
                                                          : "byte " + std::to_string(static_cast<unsigned char>(c));
}

/// Returns how to write a sign of mathematics that is not ASCII; empty for all others.
std::string_view asciiFor(std::string_view text) {
    constexpr std::pair<std::string_view, std::string_view> kSigns[] = {
        {"\u00b2", "^2"}, {"\u00b3", "^3"}, {"\u00d7", "*"}, {"\u00b7", "*"},    {"\u22c5", "*"},
        {"\u00f7", "/"},  {"\u2212", "-"},  {"\u2013", "-"}, {"\u221a", "sqrt"}, {"\u03c0", "pi"},
        {"\u2264", "<="}, {"\u2265", ">="}, {"\u2260", "!="}};
    const std::string_view character = firstCharacter(text);
    for (const auto &[sign, ascii] : kSigns) {
        if (sign == character) {
            return ascii;
        }
    }
    return {};
}

/// A recursive-descent parser with one function per level of precedence, lowest first. Stops at the first fault.
class Parser {
  public:
    Parser(std::string_view text, FormulaNames names) : text_(text), names_(names) {}

    std::variant<ParsedExpression, ExpressionFault> run() {
        parseChoice();
        skipBlanks();
        if (!fault_ && at_ < text_.size()) {
            failUnexpected("an operator or the end");
        }
        if (fault_) {
            return *fault_;
        }
        return ParsedExpression{std::move(code_), std::move(functions_)};
    }

  private:
    void fail(std::string message) {
        if (!fault_) {
            fault_ = ExpressionFault{at_, std::move(message)};
        }
    }
    void failUnexpected(const char *expected) {
        const std::string_view ascii = asciiFor(text_.substr(at_));
        fail("unexpected " + quoted(text_.substr(at_)) +
             (ascii.empty() ? "; expected " + std::string(expected) : "; write " + std::string(ascii)));
    }
    void skipBlanks() {
        while (at_ < text_.size() &&
               (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r')) {
            ++at_;
        }
    }
    bool take(std::string_view token) {
        skipBlanks();
        if (fault_ || text_.substr(at_, token.size()) != token) {
            return false;
        }
        at_ += token.size();
        return true;
    }
    void emit(ExpressionOp op, double constant = 0.0) { code_.push_back({op, constant}); }

    void parseChoice() {
        if (++nesting_ > kMaxNesting) {
            fail("nested too deeply; expected at most " + std::to_string(kMaxNesting) + " levels");
        }
        if (!fault_) {
            parseOr();
            if (take("?")) {
                parseChoice();
                if (!take(":")) {
                    fail("missing ':' after '?'");
                }
                parseChoice();
                emit(ExpressionOp::Select);
            }
        }
        --nesting_;
    }
    void parseOr() {
        parseAnd();
        while (take("||")) {
            parseAnd();
            emit(ExpressionOp::Or);
        }
    }
    void parseAnd() {
        parseComparison();
        while (take("&&")) {
            parseComparison();
            emit(ExpressionOp::And);
        }
    }
    void parseComparison() {
        parseSum();
        while (!fault_) {
            ExpressionOp op{};
            if (take("<=")) {
                op = ExpressionOp::LessEqual;
            } else if (take(">=")) {
                op = ExpressionOp::GreaterEqual;
            } else if (take("==")) {
                op = ExpressionOp::Equal;
            } else if (take("!=")) {
                op = ExpressionOp::NotEqual;
            } else if (take("<")) {
                op = ExpressionOp::Less;
            } else if (take(">")) {
                op = ExpressionOp::Greater;
            } else {
                return;
            }
            parseSum();
            emit(op);
        }
    }
    void parseSum() {
        parseProduct();
        while (!fault_) {
            if (take("+")) {
                parseProduct();
                emit(ExpressionOp::Add);
            } else if (take("-")) {
                parseProduct();
                emit(ExpressionOp::Subtract);
            } else {
                return;
            }
        }
    }
    void parseProduct() {
        parseSigned();
        while (!fault_) {
            if (take("*")) {
                parseSigned();
                emit(ExpressionOp::Multiply);
            } else if (take("/")) {
                parseSigned();
                emit(ExpressionOp::Divide);
            } else {
                return;
            }
        }
    }
    // Parses a signed term; a sign binds less tightly than a power: -x^2 is -(x^2).
    void parseSigned() {
        if (take("-")) {
            parsePower();
            emit(ExpressionOp::Negate);
        } else {
            take("+");
            parsePower();
        }
    }
    void parsePower() {
        parseOperand();
        if (take("^")) {
            if (++nesting_ > kMaxNesting) {
                fail("nested too deeply; expected at most " + std::to_string(kMaxNesting) + " levels");
            }
            if (!fault_) {
                parseSigned(); // right-associative
            }
            --nesting_;
            emit(ExpressionOp::Power);
        }
    }
    void parseOperand() {
        skipBlanks();
        if (fault_) {
            return;
        }
        if (at_ >= text_.size()) {
            fail("unexpected end; expected a number, a name or '('");
        } else if (isDigit(text_[at_]) || text_[at_] == '.') {
            parseNumber();
        } else if (isNameStart(text_[at_])) {
            parseName();
        } else if (take("(")) {
            parseChoice();
            if (!take(")")) {
                fail("missing ')'");
            }
        } else {
            failUnexpected("a number, a name or '('");
        }
    }
    void parseNumber() {
        double value = 0.0;
        const char *const begin = text_.data() + at_;
        const auto [end, status] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (status != std::errc() || !std::isfinite(value)) {
            fail("invalid number");
            return;
        }
        at_ += static_cast<std::size_t>(end - begin);
        emit(ExpressionOp::Push, value);
    }
    void parseName() {
        const std::size_t begin = at_;
        std::size_t end = at_;
        while (end < text_.size() && (isNameStart(text_[end]) || isDigit(text_[end]))) {
            ++end;
        }
        const std::string_view name = text_.substr(begin, end - begin);
        for (const NamedFunction &function : kFunctions) {
            if (function.name == name) {
                if (function.op == ExpressionOp::Distance && !names_.coordinates) {
                    fail("dist needs x and y; use hypot(a, b)");
                    return;
                }
                at_ = end;
                parseArguments(function);
                return;
            }
        }
        if (parsePlaneFunction(name, end)) {
            return;
        }
        if (names_.coordinates && isCoordinate(name)) {
            emit(name == "x" ? ExpressionOp::PushX : ExpressionOp::PushY);
        } else if (!emitConstant(name) && !emitValue(name)) {
            fail("unknown name '" + std::string(name) + "'; expected " + (names_.coordinates ? "x, y, " : "") +
                 (names_.values != nullptr ? "a parameter, " : "") + "pi, e or a function" +
                 (names_.functions != nullptr ? ", also " + names_.functions->names() : ""));
            return;
        }
        at_ = end;
    }
    /// Parses the call of a function of the position, if the name before `end` is one and a parenthesis follows.
    bool parsePlaneFunction(std::string_view name, std::size_t end) {
        const std::size_t next = text_.find_first_not_of(" \t\n\r", end);
        if (names_.functions == nullptr || next == std::string_view::npos || text_[next] != '(') {
            return false;
        }
        const bool shore = name == "shore";
        std::shared_ptr<const PlaneFunction> function = shore ? nullptr : names_.functions->find(name);
        if (!shore && function == nullptr) {
            return false;
        }
        at_ = next + 1;
        parseChoice();
        if (!take(",")) {
            fail("missing ',': '" + std::string(name) + "' takes a place, such as " + std::string(name) + "(x, y)");
        }
        parseChoice();
        const std::vector<std::string> parts = shore ? parseParts() : std::vector<std::string>();
        if (!take(")")) {
            fail(shore ? "missing ')'; the names of boundary parts are in quotes: shore(x, y, 'coast')"
                       : "missing ')'");
        }
        if (!fault_ && shore) {
            auto found = names_.functions->shore(parts);
            if (const auto *const message = std::get_if<std::string>(&found)) {
                fail(*message);
            } else {
                function = std::get<0>(found);
            }
        }
        emit(ExpressionOp::Call, static_cast<double>(functions_.size()));
        functions_.push_back(std::move(function));
        return true;
    }
    /// Parses names in single quotes, with a comma before each.
    std::vector<std::string> parseParts() {
        std::vector<std::string> parts;
        while (take(",")) {
            const std::size_t close = take("'") ? text_.find('\'', at_) : std::string_view::npos;
            if (close == std::string_view::npos) {
                fail("expected the name of a boundary part in single quotes, such as 'coast'");
                break;
            }
            parts.emplace_back(text_.substr(at_, close - at_));
            at_ = close + 1;
        }
        return parts;
    }
    bool emitValue(std::string_view name) {
        if (names_.values == nullptr) {
            return false;
        }
        const auto known = names_.values->find(name);
        if (known == names_.values->end()) {
            return false;
        }
        emit(ExpressionOp::Push, known->second);
        return true;
    }
    bool emitConstant(std::string_view name) {
        for (const NamedConstant &constant : kConstants) {
            if (constant.name == name) {
                emit(ExpressionOp::Push, constant.value);
                return true;
            }
        }
        return false;
    }
    void parseArguments(const NamedFunction &function) {
        if (!take("(")) {
            fail("missing '(' after '" + std::string(function.name) + "'");
            return;
        }
        int count = 0;
        do {
            parseChoice();
            ++count;
            if (function.arguments < 0 && count > 1) {
                emit(function.op);
            }
        } while (take(","));
        if (function.arguments > 0 && count != function.arguments) {
            fail("'" + std::string(function.name) + "' takes " + std::to_string(function.arguments) +
                 (function.arguments == 1 ? " argument, got " : " arguments, got ") + std::to_string(count));
        } else if (!take(")")) {
            fail("missing ')'");
        } else if (function.arguments > 0) {
            emit(function.op);
        } else if (function.mean) {
            emit(ExpressionOp::Push, count);
            emit(ExpressionOp::Divide);
        }
    }

    std::string_view text_;
    FormulaNames names_;
    std::size_t at_ = 0;
    int nesting_ = 0;
    std::vector<ExpressionInstruction> code_;
    std::vector<std::shared_ptr<const PlaneFunction>> functions_;
    std::optional<ExpressionFault> fault_;
};

} // namespace

std::variant<ParsedExpression, ExpressionFault> parseExpression(std::string_view text, FormulaNames names) {
    return Parser(text, names).run();
}

bool isReservedName(std::string_view name) {
    const auto called = [name](const auto &known) { return known.name == name; };
    return isCoordinate(name) || std::any_of(kConstants.begin(), kConstants.end(), called) ||
           std::any_of(kFunctions.begin(), kFunctions.end(), called);
}

std::vector<std::string_view> namesIn(std::string_view text) {
    std::vector<std::string_view> names;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at + 1;
        if (isNameStart(text[at])) {
            while (end < text.size() && (isNameStart(text[end]) || isDigit(text[end]))) {
                ++end;
            }
            names.push_back(text.substr(at, end - at));
        } else if (text[at] == '\'' && text.find('\'', end) != std::string_view::npos) {
            end = text.find('\'', end) + 1;
        } else if (isDigit(text[at]) || text[at] == '.') { // a letter after a digit is part of a number such as 2.e3
            while (end < text.size() && (isNameStart(text[end]) || isDigit(text[end]) || text[end] == '.')) {
                ++end;
            }
        }
        at = end;
    }
    return names;
}

} // namespace forefront
