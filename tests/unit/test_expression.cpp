#include "core/engine/spacing/parts/expression/expression.hpp"

#include <doctest/doctest.h>
#include <muParser.h>

#include <cmath>
#include <random>

using namespace forefront;

namespace {

ExpressionProgram compiled(const std::string &text) {
    auto program = compileExpression(text);
    REQUIRE_MESSAGE(program.ok(), text << ": " << (program.ok() ? std::string() : toString(program.faults().front())));
    return *program;
}

/// Random formulas of bounded values, so that rounding stays comparable.
class Formulas {
  public:
    explicit Formulas(unsigned seed) : random_(seed) {}

    std::string make(int depth) {
        if (depth == 0 || pick(8) == 0) {
            return leaf();
        }
        static const char *const unary[] = {"sin",  "cos", "atan", "abs",   "sqrt", "tanh", "sign",
                                            "rint", "exp", "ln",   "asinh", "cosh", "log2", "log10"};
        const std::string one = make(depth - 1);
        const std::string two = make(depth - 1);
        switch (pick(8)) {
        case 0:
            return joined({"(", one, "+", two, ")"});
        case 1:
            return joined({one, "-", two});
        case 2:
            return joined({"(", one, ")*(", two, ")"});
        case 3:
            return joined({"-(", one, ")/(2+abs(", two, "))"});
        case 4:
            return joined({pick(2) == 0 ? "min(" : "max(", one, ", ", two, ")"});
        case 5:
            return joined({"(", one, pick(2) == 0 ? ")^2" : ")^3"});
        case 6:
            return joined({"(", one, pick(2) == 0 ? "<" : ">=", two, " ? ", make(depth - 1), " : ", leaf(), ")"});
        default:
            return joined({unary[pick(14)], "(", one, ")"});
        }
    }
    double number() { return std::uniform_real_distribution<double>(-2.0, 2.0)(random_); }

  private:
    static std::string joined(std::initializer_list<std::string_view> parts) {
        std::string text;
        for (const std::string_view part : parts) {
            text += part;
        }
        return text;
    }
    int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
    std::string leaf() {
        switch (pick(4)) {
        case 0:
            return "x";
        case 1:
            return "y";
        case 2:
            return "pi";
        default:
            return std::to_string(0.1 * (1 + pick(30)));
        }
    }
    std::mt19937 random_;
};

} // namespace

TEST_CASE("Expression: precedence, signs, powers and choices are those of muparser") {
    const auto at = [](const char *text) { return compiled(text).evaluate({3.0, 2.0}); };
    CHECK(at("-x^2") == -9.0);
    CHECK(at("2^3^2") == 512.0);
    CHECK(at("2^-y") == 0.25);
    CHECK(at("1+2*x-4/y") == 5.0);
    CHECK(at("x>2 && y<1 ? 10 : x>2 ? 20 : 30") == 20.0);
    CHECK(at("2<3<1") == 0.0);
    CHECK(at("min(x, y, 1.5)") == 1.5);
    CHECK(at("avg(x, y)") == 2.5);
    CHECK(at("sum(x, y, 1)") == 6.0);
    CHECK(at("1e2 + .5 + 5.") == 105.5);
    CHECK(at("dist(0, -2)") == 5.0);
    CHECK(at("hypot(x, 4)") == 5.0);
    CHECK(at("rint(2.5)") == 3.0);
}

TEST_CASE("Expression: the root of a sum of squares gives the same doubles, distance to a point or not") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-50.0, 50.0);
    for (int n = 0; n < 200; ++n) {
        const Vec2 p{number(random), number(random)};
        const auto at = [&](const char *text) { return compiled(text).evaluate(p); };
        const auto root = [](double a, double b) { return std::sqrt(a * a + b * b); };
        CHECK(at("sqrt((x-30.1)^2+(y-20.3)^2)") == root(p.x - 30.1, p.y - 20.3));
        CHECK(at("1+2*sqrt((x+3.7)^2+y^2)") == 1.0 + 2.0 * root(p.x + 3.7, p.y));
        CHECK(at("sqrt((y-3.7)^2+(x-0.3)^2)") == root(p.y - 3.7, p.x - 0.3));
        CHECK(at("sqrt((x-3.7)^2+(x-0.3)^2)") == root(p.x - 3.7, p.x - 0.3));
        CHECK(at("sqrt((2*x-3.7)^2+(y-0.3)^2)") == root(2.0 * p.x - 3.7, p.y - 0.3));
        CHECK(at("x-sqrt(x^2+(y-0.3)^2)") == p.x - root(p.x, p.y - 0.3));
    }
}

TEST_CASE("Expression: random formulas agree with muparser") {
    Formulas formulas(42);
    int compared = 0;
    for (int n = 0; n < 1500; ++n) {
        const std::string text = formulas.make(4);
        const ExpressionProgram program = compiled(text);
        double x = 0.0;
        double y = 0.0;
        mu::Parser parser;
        parser.EnableOptimizer(false);
        parser.DefineVar("x", &x);
        parser.DefineVar("y", &y);
        parser.DefineConst("pi", M_PI);
        parser.SetExpr(text);
        for (int i = 0; i < 5; ++i) {
            x = formulas.number();
            y = formulas.number();
            const double expected = parser.Eval();
            const double value = program.evaluate({x, y});
            if (!std::isfinite(expected) || std::fabs(expected) > 1e6) {
                CHECK(std::isnan(value) == std::isnan(expected));
                continue;
            }
            CHECK_MESSAGE(std::fabs(value - expected) <= 1e-12 * (1.0 + std::fabs(expected)), text);
            ++compared;
        }
    }
    CHECK(compared > 4000);
}

TEST_CASE("Expression: bulk evaluation gives bitwise the same values") {
    Formulas formulas(43);
    std::vector<Vec2> points(100);
    std::vector<double> values(points.size());
    for (int n = 0; n < 200; ++n) {
        const ExpressionProgram program = compiled(formulas.make(4));
        for (Vec2 &p : points) {
            p = {formulas.number(), formulas.number()};
        }
        program.evaluateMany(points, values);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double single = program.evaluate(points[i]);
            REQUIRE(((values[i] == single) || (std::isnan(values[i]) && std::isnan(single))));
        }
    }
}

TEST_CASE("Expression: interval bounds hold all values in the box") {
    Formulas formulas(44);
    int bounded = 0;
    for (int n = 0; n < 1500; ++n) {
        const std::string text = formulas.make(4);
        const ExpressionProgram program = compiled(text);
        const Vec2 corner{formulas.number(), formulas.number()};
        const Box2 box{corner, corner + Vec2{0.3, 0.2}};
        const ValueRange range = program.range(box);
        if (range.undefined) {
            continue;
        }
        ++bounded;
        for (int j = 0; j <= 6; ++j) {
            for (int i = 0; i <= 6; ++i) {
                const double value = program.evaluate(
                    {std::min(box.max.x, box.min.x + 0.05 * i), std::min(box.max.y, box.min.y + 0.2 * j / 6)});
                REQUIRE_MESSAGE(value >= range.low, text);
                REQUIRE_MESSAGE(value <= range.high, text);
            }
        }
    }
    CHECK(bounded > 700);
}

TEST_CASE("Expression: faults say what is wrong and what was expected") {
    const auto messageOf = [](const char *text) {
        const auto program = compileExpression(text);
        REQUIRE_MESSAGE(!program.ok(), text);
        return program.faults().front().message;
    };
    CHECK(messageOf("1 + z") == "expression, column 5: unknown name 'z'; expected x, y, pi, e or a function");
    CHECK(messageOf("x ** 2") == "expression, column 4: unexpected '*'; expected a number, a name or '('");
    CHECK(messageOf("2 3") == "expression, column 3: unexpected '3'; expected an operator or the end");
    CHECK(messageOf("1 +") == "expression, column 4: unexpected end; expected a number, a name or '('");
    CHECK(messageOf("sqrt(1, 2)") == "expression, column 10: 'sqrt' takes 1 argument, got 2");
    CHECK(messageOf("max(1") == "expression, column 6: missing ')'");
    CHECK(messageOf("x > 1 ? 2") == "expression, column 10: missing ':' after '?'");
    CHECK(messageOf("3\u00b2") == "expression, column 2: unexpected '\u00b2'; write ^2");
    CHECK(messageOf("2 \u00d7 x") == "expression, column 3: unexpected '\u00d7'; write *");
    CHECK(messageOf("\u03c1") == "expression, column 1: unexpected '\u03c1'; expected a number, a name or '('");
    CHECK(messageOf("\xe2\x88") == "expression, column 1: unexpected byte 226; expected a number, a name or '('");
    CHECK(messageOf("\xff") == "expression, column 1: unexpected byte 255; expected a number, a name or '('");
}

TEST_CASE("Expression: faults name their place once") {
    for (const char *text : {"1 + z", "1 + foo(x)", "1 + ", "max(1", "x ** 2", "1, 2", "x $ y", "2 3"}) {
        CAPTURE(text);
        const auto program = compileExpression(text);
        REQUIRE_FALSE(program.ok());
        const Diagnostic &fault = program.faults().front();
        CAPTURE(fault.message);
        const std::string place = "column " + std::to_string(fault.column) + ": ";
        CHECK(fault.message.find(place) != std::string::npos);
        CHECK(fault.message.find("position") == std::string::npos);
    }
}

TEST_CASE("Expression: faults carry their column") {
    const auto columnOf = [](const char *text) {
        const auto program = compileExpression(text);
        REQUIRE_MESSAGE(!program.ok(), text);
        CHECK(program.faults().front().code == "expression-syntax");
        return program.faults().front().column;
    };
    CHECK(columnOf("1 + foo(x)") == 5);
    CHECK(columnOf("1 + z") == 5);
    CHECK(columnOf("(1 + x") >= 6);
    CHECK(columnOf("x ** 2") == 4);
    CHECK(columnOf("") == 1);
    CHECK(columnOf("x = 3") >= 2);
    CHECK(columnOf("1, 2") >= 1);
    CHECK(columnOf("min()") >= 4);
    CHECK(columnOf("sqrt(1, 2)") >= 5);
    CHECK(columnOf("x $ y") == 3);
}

TEST_CASE("Expression: refuses deep nesting, very long text and invalid bytes") {
    CHECK(!compileExpression(std::string(3000, '(') + "x" + std::string(900, ')')).ok());
    CHECK(!compileExpression(std::string(1000, '(') + "x" + std::string(1000, ')')).ok());
    CHECK(!compileExpression(std::string(100000, 'x')).ok());
    CHECK(!compileExpression(std::string("x\0+1", 4)).ok());
    CHECK(!compileExpression("\xff\xfe").ok());
    CHECK(!compileExpression("\"text\"").ok());
    std::string tower = "x";
    for (int i = 0; i < 500; ++i) {
        tower += "^x";
    }
    CHECK(!compileExpression(tower).ok());
    std::mt19937 random(9);
    const std::string alphabet = "xy01.+-*/^()<>=&|?:, sqrtminabe_\"!";
    for (int n = 0; n < 5000; ++n) {
        std::string text;
        for (int i = 0; i < 12; ++i) {
            text += alphabet[random() % alphabet.size()];
        }
        if (const auto program = compileExpression(text); program.ok()) {
            static_cast<void>(program->evaluate({1.0, 2.0}));
        } else {
            CHECK(program.faults().front().column >= 1);
        }
    }
}
