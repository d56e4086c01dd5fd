#include "app/batch/options.hpp"

#include "app/batch/exit_code.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Parses the whole text as a number of that type, with or without a sign.
template <class Number>
std::optional<Number> parse(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) {
        text.remove_prefix(1);
    }
    Number value{};
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::string shown(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

/// Refuses values that `accepts` rejects.
template <class Accepts>
CLI::Validator check(std::string expected, Accepts accepts) {
    return {[expected = std::move(expected), accepts](const std::string &text) {
                return accepts(text) ? std::string() : "expected " + expected + ", got '" + text + '\'';
            },
            ""};
}

/// Lists the arguments that no option or input takes, in order.
std::string unexpectedArguments(const std::vector<std::string> &arguments) {
    std::string options, others;
    for (const std::string &argument : arguments) {
        std::string &list = argument.size() > 1 && argument.front() == '-' ? options : others;
        list += (list.empty() ? "'" : ", '") + argument + '\'';
    }
    return options.empty() ? "unexpected argument " + others : "unknown option " + options;
}

} // namespace

CLI::Validator positiveNumber() {
    return check("a positive number", [](const std::string &text) {
        const auto value = parse<double>(text);
        return value && std::isfinite(*value) && *value > 0.0;
    });
}

CLI::Validator nonNegativeNumber() {
    return check("a number of at least 0", [](const std::string &text) {
        const auto value = parse<double>(text);
        return value && std::isfinite(*value) && *value >= 0.0;
    });
}

CLI::Validator numberWithin(double minimum, double maximum) {
    return check("a number from " + shown(minimum) + " to " + shown(maximum),
                 [minimum, maximum](const std::string &text) {
                     const auto value = parse<double>(text);
                     return value && *value >= minimum && *value <= maximum;
                 });
}

CLI::Validator wholeNumberWithin(int minimum, int maximum) {
    return check("a whole number from " + std::to_string(minimum) + " to " + std::to_string(maximum),
                 [minimum, maximum](const std::string &text) {
                     const auto value = parse<int>(text);
                     const bool octal = value && text.ends_with('0' + std::to_string(*value)); // as CLI11 would read it
                     return value && !octal && *value >= minimum && *value <= maximum;
                 });
}

CLI::Validator oneOf(std::span<const std::string_view> words) {
    std::string expected = "one of ";
    for (const std::string_view word : words) {
        expected += word;
        expected += word == words.back() ? "" : ", ";
    }
    return check(std::move(expected), [words](const std::string &text) {
        return std::find(words.begin(), words.end(), text) != words.end();
    });
}

void addSpacingOptions(CLI::App &group, std::optional<double> &size, std::optional<std::string> &expression) {
    group.add_option("--size", size, "uniform edge length")->check(positiveNumber())->type_name("H");
    group
        .add_option("--spacing", expression,
                    "edge length as an expression in x and y, with min, max, sqrt, exp, sin, ... "
                    "and dist(a,b), the distance to (a, b)")
        ->type_name("EXPR");
}

void addInnerEdgesOption(CLI::App &app, InnerEdges &innerEdges) {
    addWordOption<InnerEdges>(
        app, "--inner-edges", innerEdges,
        "tagged edges inside the domain, in the written meshes: keep (default) or drop, for programs such as "
        "deal.II that accept tags on the boundary only")
        ->type_name("WORD");
}

void addArrangementOptions(CLI::App &app, std::optional<double> &weldTolerance, OverlapRule &overlap) {
    app.add_option("--weld", weldTolerance,
                   "join nodes and segments closer than this (default: 1e-6 of the diagonal for drawings and maps; 0 "
                   "for other files, which are joined only with --repair)")
        ->check(nonNegativeNumber())
        ->type_name("T");
    addWordOption<OverlapRule>(
        app, "--overlap", overlap,
        "where polygons of a map overlap, the later (default) or the smaller one wins; one inside another always "
        "keeps its area")
        ->type_name("RULE");
}

std::optional<int> parseOptions(CLI::App &app, int argc, const char *const *argv) {
    try {
        app.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::CallForHelp &help) {
        return app.exit(help);
    } catch (const CLI::ExtrasError &) {
        return wrongUsage(app.get_name(), unexpectedArguments(app.remaining()));
    } catch (const CLI::ParseError &error) {
        return wrongUsage(app.get_name(), error.what());
    }
}

int wrongUsage(const std::string &command, std::string_view message) {
    std::fprintf(stderr, "%s: %.*s\nRun with --help for more information.\n", command.c_str(),
                 static_cast<int>(message.size()), message.data());
    return kUsage;
}

} // namespace forefront
