#include "core/teaching/markup/math_symbols.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace forefront {

namespace {

using enum MathRole;

// Characters of the program's fonts only: see the ranges in ui/style/fonts.cpp, which a test compares with these.
constexpr MathSymbol kSymbols[] = {
    {"alpha", "α"},
    {"beta", "β"},
    {"gamma", "γ"},
    {"delta", "δ"},
    {"epsilon", "ε"},
    {"zeta", "ζ"},
    {"eta", "η"},
    {"theta", "θ"},
    {"iota", "ι"},
    {"kappa", "κ"},
    {"lambda", "λ"},
    {"mu", "μ"},
    {"nu", "ν"},
    {"xi", "ξ"},
    {"pi", "π"},
    {"rho", "ρ"},
    {"sigma", "σ"},
    {"tau", "τ"},
    {"upsilon", "υ"},
    {"phi", "φ"},
    {"chi", "χ"},
    {"psi", "ψ"},
    {"omega", "ω"},
    {"Gamma", "Γ"},
    {"Delta", "Δ"},
    {"Theta", "Θ"},
    {"Lambda", "Λ"},
    {"Xi", "Ξ"},
    {"Pi", "Π"},
    {"Sigma", "Σ"},
    {"Phi", "Φ"},
    {"Psi", "Ψ"},
    {"Omega", "Ω"},
    {"infty", "∞"},
    {"partial", "∂"},
    {"nabla", "∇"},
    {"emptyset", "∅"},
    {"angle", "∠"},
    {"degree", "°"},
    {"dots", "…"},
    {"ldots", "…"},
    {"prime", "′"},
    {"|", "‖"},
    {"%", "%"},
    {"$", "$"},
    {"_", "_"},
    {"{", "{", Opening},
    {"}", "}", Closing},
    {"cdot", "·", Binary},
    {"times", "×", Binary},
    {"div", "÷", Binary},
    {"pm", "±", Binary},
    {"mp", "∓", Binary},
    {"cup", "∪", Binary},
    {"cap", "∩", Binary},
    {"setminus", "∖", Binary},
    {"le", "≤", Relation},
    {"leq", "≤", Relation},
    {"ge", "≥", Relation},
    {"geq", "≥", Relation},
    {"ne", "≠", Relation},
    {"neq", "≠", Relation},
    {"approx", "≈", Relation},
    {"sim", "∼", Relation},
    {"equiv", "≡", Relation},
    {"propto", "∝", Relation},
    {"in", "∈", Relation},
    {"notin", "∉", Relation},
    {"parallel", "∥", Relation},
    {"to", "→", Relation},
    {"rightarrow", "→", Relation},
    {"leftarrow", "←", Relation},
    {"sin", "sin", Function},
    {"cos", "cos", Function},
    {"tan", "tan", Function},
    {"asin", "asin", Function},
    {"acos", "acos", Function},
    {"atan", "atan", Function},
    {"arcsin", "arcsin", Function},
    {"arccos", "arccos", Function},
    {"arctan", "arctan", Function},
    {"exp", "exp", Function},
    {"log", "log", Function},
    {"ln", "ln", Function},
    {"det", "det", Function},
    {"hypot", "hypot", Function},
    {"min", "min", Limit},
    {"max", "max", Limit},
    {"lim", "lim", Limit},
    {"sum", "∑", Large},
    {"prod", "∏", Large},
    {"int", "∫", Integral},
    // Characters without a command.
    {"", "+", Binary},
    {"", "−", Binary},
    {"", "–"}, // a value without a number
    {"", "/"},
    {"", "|"},
    {"", "."},
    {"", "(", Opening},
    {"", "[", Opening},
    {"", ")", Closing},
    {"", "]", Closing},
    {"", "!", Closing},
    {"", ",", Comma},
    {"", ";", Comma},
    {"", "=", Relation},
    {"", "<", Relation},
    {"", ">", Relation},
    {"", ":", Relation},
};

/// Characters of a keyboard that stand for another.
constexpr std::pair<std::string_view, std::string_view> kStandIns[] = {{"-", "−"}, {"'", "′"}, {"*", "·"}};

constexpr std::pair<std::string_view, double> kSpaces[] = {{",", 0.17}, {";", 0.28}, {" ", 0.28}, {"quad", 1.0}};

} // namespace

std::optional<MathSymbol> symbolOfCommand(std::string_view command) {
    const auto *const found = std::find_if(std::begin(kSymbols), std::end(kSymbols), [&](const MathSymbol &symbol) {
        return !command.empty() && symbol.command == command;
    });
    return found != std::end(kSymbols) ? std::optional(*found) : std::nullopt;
}

std::optional<MathSymbol> symbolOfCharacter(std::string_view character) {
    for (const auto &[typed, shown] : kStandIns) {
        if (character == typed) {
            character = shown;
        }
    }
    constexpr std::string_view kOnlyByCommand = "%$_{}"; // they mean something else in TeX or in lessons
    if (character.size() == 1 && kOnlyByCommand.find(character) != std::string_view::npos) {
        return std::nullopt;
    }
    const auto *const found = std::find_if(std::begin(kSymbols), std::end(kSymbols),
                                           [&](const MathSymbol &symbol) { return symbol.text == character; });
    return found != std::end(kSymbols) ? std::optional(*found) : std::nullopt;
}

std::optional<double> roomOfCommand(std::string_view command) {
    for (const auto &[name, room] : kSpaces) {
        if (command == name) {
            return room;
        }
    }
    return std::nullopt;
}

} // namespace forefront
