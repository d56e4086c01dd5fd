#include "app/batch/cli_options.hpp"
#include "app/batch/commands.hpp"
#include "app/batch/exit_code.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/files/rules/rules_json.hpp"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

namespace forefront {

namespace {

constexpr const char *kRulesExamples = R"help(
Examples:
  forefront rules
        the rules with their defaults and limits, and which are Lo's
  forefront rules mine.json
        check a file of rules; print what differs from the defaults
  forefront mesh plate.json -o plate.vtu --method classic --rules mine.json
        mesh with them; film and trace have the same option

A file of rules is a JSON object such as {"base": "oldest", "radius": 2}. Rules that it leaves out have their
defaults. Improvement is set by --improve.

Exit codes: 0 done, 1 file refused (faults on stderr, one per line), 2 usage error.)help";

/// Returns the values that a rule can have: "0.2 to 5 ρ", "on or off".
std::string boundsText(const FrontRuleInfo &info) {
    switch (info.kind) {
    case RuleKind::Choice:
        return wordList<BaseRule>();
    case RuleKind::Switch:
        return "true (on) or false (off)";
    case RuleKind::Number:
    case RuleKind::Whole:
        break;
    }
    const std::string unit = info.unit;
    return numberText(info.minimum, 7) + " to " + numberText(info.maximum, 7) + (unit.empty() ? "" : " " + unit);
}

/// Returns the default of a rule as a file of rules has it.
std::string defaultText(FrontRule rule) {
    const std::string text = valueText(FrontRules(), rule);
    return frontRuleInfo(rule).kind == RuleKind::Switch ? (text == "on" ? "true (on)" : "false (off)") : text;
}

void printList() {
    for (const FrontRule rule : valuesOf<FrontRule>()) {
        const FrontRuleInfo &info = frontRuleInfo(rule);
        std::printf("%s: %s; default %s; step %d, %s\n        %s: %s\n", std::string(wordOf(rule)).c_str(),
                    boundsText(info).c_str(), defaultText(rule).c_str(), info.step, originText(info.origin), info.name,
                    info.meaning);
    }
    std::printf(
        "\nLo's: part of his method as described. Ours: chosen for this program, where the description leaves it "
        "open.\n");
}

} // namespace

int rulesCommand(const CommandLine &line) {
    std::optional<std::filesystem::path> file;
    CLI::App app("Lists the rules of the classic method that can be changed, or checks a file of rules.",
                 "forefront rules");
    app.footer(kRulesExamples);
    app.add_option("FILE", file, "file of rules; default: list the rules");
    if (const auto code = parseOptions(app, line)) {
        return *code;
    }
    if (!file) {
        printList();
        return kDone;
    }
    const Result<FrontRules> rules = readRulesFile(*file);
    if (!rules) {
        printFaults(rules.faults());
        return kRefused;
    }
    const std::string changes = changesText(*rules);
    std::printf("%s\n", changes.empty() ? "all rules have their defaults" : changes.c_str());
    return kDone;
}

} // namespace forefront
