#include "core/spacing/parts/expression/expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>

namespace forefront {
namespace {

constexpr std::size_t kLongest = 4000; ///< characters; keeps parsing short whatever is pasted

/// `message`: muparser's, which tells the place in its own count, from 0, or a sentence without a place.
Diagnostics syntaxError(std::string message, std::size_t column) {
    static const std::regex place("( found)? at position -?[0-9]+");
    message = std::regex_replace(message, place, "");
    while (!message.empty() && (message.back() == '.' || message.back() == ' ')) {
        message.pop_back();
    }
    Diagnostics faults = error(
        "expression-syntax", "In the spacing expression, column " + std::to_string(column) + ": " + message,
        "write a formula in x and y such as max(0.1, 0.2*dist(3, 2)), with + - * / ^, min, max, sqrt, abs, exp, ln, "
        "sin, atan2 and the like; dist(a, b) is the distance to (a, b)");
    faults.front().column = static_cast<int>(column);
    return faults;
}

/// The fault muparser finds, if any. Names beyond its own are given stand-ins: only the syntax is asked for here.
std::optional<Diagnostics> judge(const std::string &text) {
    try {
        double x = 0.25;
        double y = 0.5;
        mu::Parser parser;
        parser.DefineVar("x", &x);
        parser.DefineVar("y", &y);
        parser.DefineConst("pi", std::numbers::pi);
        parser.DefineConst("e", std::numbers::e);
        parser.DefineFun(
            "dist", +[](double a, double b) { return std::hypot(a, b); });
        parser.DefineFun(
            "hypot", +[](double a, double b) { return std::hypot(a, b); });
        parser.DefineFun(
            "pow", +[](double a, double b) { return std::pow(a, b); });
        parser.SetExpr(text);
        parser.Eval();
        if (parser.GetNumResults() != 1) {
            return syntaxError("Several values separated by commas", 1);
        }
    } catch (const mu::Parser::exception_type &fault) {
        const auto place = static_cast<std::size_t>(std::max(0, fault.GetPos()));
        return syntaxError(fault.GetMsg(), std::min(place, text.size()) + 1);
    } catch (const std::exception &fault) {
        return syntaxError(fault.what(), 1);
    }
    return std::nullopt;
}

} // namespace

Result<ExpressionProgram> compileExpression(const std::string &text) {
    if (text.size() > kLongest) {
        return syntaxError("The expression has more than " + std::to_string(kLongest) + " characters", kLongest + 1);
    }
    // Own parsing first: it is bounded in depth, so that muparser sees only what is harmless; muparser words the fault.
    auto compiled = ExpressionProgram::compile(text);
    const auto *const own = std::get_if<ExpressionFault>(&compiled);
    if (own != nullptr && own->message.find("nested too deeply") != std::string::npos) {
        return syntaxError(own->message, own->column + 1);
    }
    if (auto fault = judge(text)) {
        return *std::move(fault);
    }
    if (own != nullptr) {
        return syntaxError(own->message, own->column + 1);
    }
    return std::move(std::get<ExpressionProgram>(compiled));
}

} // namespace forefront
