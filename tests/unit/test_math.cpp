#include "core/engine/base/result.hpp"
#include "core/teaching/lesson_page/math_html.hpp"
#include "core/teaching/markup/math.hpp"
#include "core/teaching/markup/math_layout.hpp"
#include "core/teaching/markup/math_symbols.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

using namespace forefront;

namespace {

/// Formulas that show every construct, and how they read.
struct MathSample {
    const char *tex;
    const char *plain;
};
constexpr MathSample kMathSamples[] = {
    {"x", "x"},
    {"x_1", "x_1"},
    {"x^2", "x^2"},
    {"e_k^{2n}", "e_k^(2n)"},
    {"\\frac{1}{4}", "1/4"},
    {"\\frac{a+b}{2}", "(a + b)/2"},
    {"\\sqrt{3}", "√3"},
    {"\\sqrt[3]{E/e}", "3√(E/e)"},
    {"\\sum_{i=1}^n x_i", "∑_(i = 1)^n x_i"},
    {"\\prod_k k", "∏_k k"},
    {"\\int_0^1 f", "∫_0^1 f"},
    {"\\rho \\le 2 \\cdot \\alpha", "ρ ≤ 2 · α"},
    {"a \\ge b \\ne c \\approx d", "a ≥ b ≠ c ≈ d"},
    {"2 \\times 3 - 1", "2 × 3 − 1"},
    {"-x = (-1)", "−x = (−1)"},
    {"x \\to \\infty", "x → ∞"},
    {"\\overline{AB}", "AB"},
    {"\\sin x + \\log(y)", "sin x + log(y)"},
    {"\\sin -x", "sin −x"},
    {"\\max_k h_k", "max_k h_k"},
    {"\\left(\\frac{L}{\\rho}, \\frac{\\rho}{L}\\right)", "(L/ρ, ρ/L)"},
    {"\\left[x\\right| \\left. y \\right|", "[x|y|"},
    {"\\text{per element}", "per element"},
    {"\\mathrm{AB}", "AB"},
    {"0.25\\,|AB|", "0.25 |AB|"},
    {"\\{x\\}", "{x}"},
    {"5\\%", "5%"},
    {"f'", "f′"},
    {"\\value{front}", "front"},
    {"ρ·√", nullptr}, // a root needs its command
};

/// A font whose letters are all 0.5 ems wide.
class SquareFont final : public MathFont {
  public:
    MathExtent extentOf(std::string_view text, bool, int level) const override {
        const auto letters = std::count_if(text.begin(), text.end(),
                                           [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; });
        const bool deep = text.find_first_of("gpqy") != std::string_view::npos;
        return {0.5 * em(level) * static_cast<double>(letters), 0.7 * em(level), (deep ? 0.2 : 0.0) * em(level)};
    }
    double em(int level) const override { return level == 0 ? 20.0 : 15.0; }
};

/// The rectangle of the ink of a part of a formula, y down.
struct InkBox {
    double left, top, right, bottom;
};

std::vector<InkBox> inkBoxesOf(const MathLayout &layout) {
    std::vector<InkBox> inks;
    for (const MathText &text : layout.texts) {
        inks.push_back({text.at.x, text.at.y - text.extent.ascent, text.at.x + text.extent.width,
                        text.at.y + text.extent.descent});
    }
    return inks;
}

MathLayout mathLayoutOf(const char *tex, bool display = false) {
    const Result<MathNode> formula = parseMath(tex);
    REQUIRE_MESSAGE(formula.ok(), tex);
    return layoutMath(*formula, SquareFont(), display);
}

} // namespace

TEST_CASE("Math: every construct is read, and reads aloud as plain text") {
    for (const MathSample &sample : kMathSamples) {
        CAPTURE(sample.tex);
        const Result<MathNode> formula = parseMath(sample.tex);
        CHECK(formula.ok() == (sample.plain != nullptr));
        if (formula && sample.plain != nullptr) {
            CHECK(plainMath(*formula) == sample.plain);
        }
    }
}

TEST_CASE("Math: a formula with a fault names it and its place") {
    const struct {
        const char *tex, *message;
        int column;
    } faults[] = {{"", "the formula is empty", 1},
                  {"a + \\foo", "unknown command \\foo", 5},
                  {"a \\", "unknown command \\ ", 3},
                  {"a & b", "unknown character '&'", 3},
                  {"a + é", "unknown character", 5},
                  {"\\frac{1}2", "expected { after \\frac{...}", 9},
                  {"\\frac12", "expected { after \\frac", 6},
                  {"\\sqrt x", "expected { after \\sqrt", 7},
                  {"\\sqrt[3{x}", "the degree of a root", 6},
                  {"\\overline", "expected { after \\overline", 10},
                  {"{a", "a brace is not closed", 1},
                  {"a}", "a closing brace", 2},
                  {"a{}", "nothing between the braces", 2},
                  {"\\text{}", "nothing between the braces", 6},
                  {"\\text{a{b}", "braces within \\text", 6},
                  {"\\text{a", "a brace is not closed", 6},
                  {"^2", "^ has nothing before it", 1},
                  {"x^", "expected an index or exponent", 3},
                  {"x^1^2", "a second ^", 4},
                  {"x_a_b", "a second _", 4},
                  {"10^12", "a number of several digits", 4},
                  {"\\left(x", "\\left without \\right", 1},
                  {"x\\right)", "\\right without \\left", 2},
                  {"\\left<x\\right>", "expected a bracket after \\left", 6},
                  {"\\left(x\\right", "expected a bracket after \\right", 14}};
    for (const auto &[tex, message, column] : faults) {
        CAPTURE(tex);
        const Result<MathNode> formula = parseMath(tex);
        REQUIRE_FALSE(formula.ok());
        CHECK(formula.faults().front().code == "bad-formula");
        CHECK_MESSAGE(formula.faults().front().message.starts_with(message), formula.faults().front().message);
        CHECK(formula.faults().front().column == column);
    }
    CHECK_FALSE(parseMath(std::string(1001, 'x')).ok());
    CHECK(parseMath(std::string(1000, 'x')).ok());
    CHECK(parseMath(std::string(11, '{') + 'x' + std::string(11, '}')).ok());
    CHECK_FALSE(parseMath(std::string(12, '{') + 'x' + std::string(12, '}')).ok());
}

TEST_CASE("Math: characters of a formula do not overlap, and stay within its extent") {
    for (const MathSample &sample : kMathSamples) {
        for (const bool display : {false, true}) {
            if (sample.plain == nullptr) {
                continue;
            }
            CAPTURE(sample.tex);
            const MathLayout layout = mathLayoutOf(sample.tex, display);
            const std::vector<InkBox> inks = inkBoxesOf(layout);
            constexpr double kSlack = 1e-9;
            for (std::size_t i = 0; i < inks.size(); ++i) {
                CHECK(inks[i].left >= -kSlack);
                CHECK(inks[i].right <= layout.extent.width + kSlack);
                CHECK(inks[i].top >= -layout.extent.ascent - kSlack);
                CHECK(inks[i].bottom <= layout.extent.descent + kSlack);
                for (std::size_t k = 0; k < i; ++k) {
                    const bool apart = inks[i].left >= inks[k].right - kSlack ||
                                       inks[k].left >= inks[i].right - kSlack ||
                                       inks[i].top >= inks[k].bottom - kSlack || inks[k].top >= inks[i].bottom - kSlack;
                    CHECK(apart);
                }
            }
            for (const MathStroke &stroke : layout.strokes) {
                for (const Vec2 point : stroke.points) {
                    CHECK(point.x >= -kSlack);
                    CHECK(point.x <= layout.extent.width + kSlack);
                    CHECK(point.y >= -layout.extent.ascent - kSlack);
                    CHECK(point.y <= layout.extent.descent + kSlack);
                }
            }
        }
    }
}

TEST_CASE("Math: letters stand on the baseline, indices below it, exponents and numerators above") {
    const MathLayout row = mathLayoutOf("a + b");
    CHECK(std::all_of(row.texts.begin(), row.texts.end(), [](const MathText &text) { return text.at.y == 0.0; }));
    CHECK(row.extent.descent == 0.0);

    const MathLayout scripts = mathLayoutOf("x_i^2");
    REQUIRE(scripts.texts.size() == 3);
    CHECK(scripts.texts[0].at.y == 0.0);
    CHECK(scripts.texts[1].at.y > 0.0);
    CHECK(scripts.texts[2].at.y < 0.0);
    CHECK(scripts.texts[1].level == 1);

    const MathLayout fraction = mathLayoutOf("\\frac{a}{b}", true);
    REQUIRE(fraction.strokes.size() == 1);
    const double bar = fraction.strokes[0].points[0].y;
    const std::vector<InkBox> inks = inkBoxesOf(fraction);
    CHECK(inks[0].bottom < bar);
    CHECK(inks[1].top > bar);
    CHECK(bar == doctest::Approx(-0.35 * 20.0)); // the middle of +
    CHECK(mathLayoutOf("\\frac{a}{b}").texts[0].level == 1);
    CHECK(fraction.texts[0].level == 0);

    const MathLayout over = mathLayoutOf("\\overline{AB}");
    REQUIRE(over.strokes.size() == 1);
    CHECK(over.strokes[0].points[0].y < -0.7 * 20.0);
    CHECK(over.strokes[0].points[1].x - over.strokes[0].points[0].x == doctest::Approx(20.0));

    const MathLayout sum = mathLayoutOf("\\sum_{k}^{n}");
    REQUIRE(sum.texts.size() == 3);
    const std::vector<InkBox> parts = inkBoxesOf(sum);
    CHECK(parts[1].top > parts[0].bottom);
    CHECK(parts[2].bottom < parts[0].top);
    const auto middle = [](const InkBox &ink) { return 0.5 * (ink.left + ink.right); };
    CHECK(middle(parts[1]) == doctest::Approx(middle(parts[0])));

    // The root covers what is below it, and brackets grow with what they hold.
    const MathLayout root = mathLayoutOf("\\sqrt{\\frac{a}{b}}", true);
    CHECK(root.strokes.size() == 2);
    CHECK(root.extent.ascent > fraction.extent.ascent);
    const MathLayout fence = mathLayoutOf("\\left(\\frac{a}{b}\\right)", true);
    REQUIRE(fence.strokes.size() == 3);
    CHECK(fence.extent.ascent >= fraction.extent.ascent);
}

TEST_CASE("Math: a long formula can be broken after relations and operators outside brackets") {
    const auto pieces = [](const char *tex) {
        std::string text;
        for (const MathNode &piece : brokenMath(*parseMath(tex))) {
            text += (text.empty() ? "" : "/") + plainMath(piece);
        }
        return text;
    };
    CHECK(pieces("x") == "x");
    CHECK(pieces("a = b + c") == "a = /b + /c");
    CHECK(pieces("a = -b") == "a = /−b");
    CHECK(pieces("f(a + b) = c") == "f(a + b) = /c");
}

TEST_CASE("Math: HTML names each formula, and escapes it") {
    const std::string html = mathHtml(*parseMath("a < \\sqrt{b}"), false);
    CHECK(html.starts_with("<span class=\"math\" role=\"math\" aria-label=\"a &lt; √b\">"));
    CHECK(html.find("<i>a</i>") != std::string::npos);
    CHECK(html.find("<span class=\"mr\">&lt;</span>") != std::string::npos);
    CHECK(html.find("<svg") != std::string::npos);
    CHECK(mathHtml(*parseMath("\\frac{1}{2}"), true).starts_with("<span class=\"math display\""));
    CHECK(escapedHtml("<a href=\"x\">&") == "&lt;a href=&quot;x&quot;&gt;&amp;");
    for (const MathSample &sample : kMathSamples) {
        if (sample.plain == nullptr) {
            continue;
        }
        const std::string each = mathHtml(*parseMath(sample.tex), false);
        const auto count = [&each](std::string_view tag) {
            std::size_t found = 0;
            for (std::size_t at = each.find(tag); at != std::string::npos; at = each.find(tag, at + 1)) {
                ++found;
            }
            return found;
        };
        CHECK(count("<span") == count("</span>"));
        CHECK(count("<i>") == count("</i>"));
        CHECK(count("<svg") == count("</svg>"));
        CHECK(count("<su") == count("</su"));
    }
}

TEST_CASE("Math: symbols have one command or character each, and brackets need their command") {
    CHECK(symbolOfCommand("rho")->text == "ρ");
    CHECK_FALSE(symbolOfCommand("").has_value());
    CHECK(symbolOfCharacter("-")->text == "−");
    CHECK(symbolOfCharacter("ρ")->text == "ρ");
    CHECK_FALSE(symbolOfCharacter("{").has_value());
    CHECK_FALSE(symbolOfCharacter("√").has_value());
}
