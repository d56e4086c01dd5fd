#include "core/engine/mesher/front_rules.hpp"

#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace forefront {

namespace {

/// Where a rule is kept.
using RuleMember =
    std::variant<double FrontRules::*, bool FrontRules::*, std::uint32_t FrontRules::*, BaseRule FrontRules::*>;

struct RuleRow {
    RuleMember member;
    FrontRuleInfo info;
};

/// Returns the row of a rule; the rows are in the order of FrontRule.
const RuleRow &rowOf(FrontRule rule) {
    using enum RuleOrigin;
    using enum RuleKind;
    static constexpr RuleRow kRows[] = {
        {&FrontRules::base,
         {"order of bases",
          "Which segment of the front is taken first. Lo's method takes the shortest, so that large "
          "elements do not block the way of small ones.",
          "", 2, Lo, Choice, 0, 3}},
        {&FrontRules::seed,
         {"seed", "Seed of the random order of bases. Each seed gives an order of its own, the same in every run.", "",
          2, Ours, Whole, 0, 1'000'000}},
        {&FrontRules::minRho,
         {"minimum of ρ",
          "The spacing at AB is at least this many lengths of AB, so that neighbouring elements differ "
          "little in size.",
          "|AB|", 3, Ours, Number, 0.1, 1}},
        {&FrontRules::maxRho,
         {"maximum of ρ", "The spacing at AB is at most this many lengths of AB.", "|AB|", 3, Ours, Number, 1.5, 4}},
        {&FrontRules::rhoAtC,
         {"share of ρ near C",
          "The spacing at AB is a mean of ρ near C, with this share, and ρ at the midpoint of AB. "
          "Lo takes the midpoint alone: 0.",
          "", 3, Ours, Number, 0, 1}},
        {&FrontRules::minHeight,
         {"minimum height of C",
          "C lies on the bisector of AB where AC and CB have the length ρ, but at least this "
          "high above AB.",
          "|AB|", 4, Ours, Number, 0.1, 1}},
        {&FrontRules::radius,
         {"search radius", "Front nodes within this distance of C are candidates.", "ρ", 5, Ours, Number, 0.2, 5}},
        {&FrontRules::secondRadius,
         {"second search radius",
          "The distance within which front nodes are candidates if the base was deferred "
          "before.",
          "ρ", 5, Ours, Number, 0.2, 10}},
        {&FrontRules::withdraw,
         {"withdrawal of C",
          "Withdraw C where a node or a segment of the front is nearer than its clearance. Without "
          "it, C is withdrawn only within 0.3 ρ, where elements would be nearly flat.",
          "", 7, Ours, Switch, 0, 1}},
        {&FrontRules::nodeClearance,
         {"clearance from nodes", "C is withdrawn if a node of the front is nearer than this.", "ρ", 7, Ours, Number,
          kLeastClearance, 1.5}},
        {&FrontRules::segmentClearance,
         {"clearance from segments", "C is withdrawn if a segment of the front is nearer than this.", "ρ", 7, Ours,
          Number, kLeastClearance, 1.5}},
        {&FrontRules::shapeWeight,
         {"weight of the shape", "Exponent of the shape factor α(ABC) in the score. 0: the shape does not count.", "",
          6, Ours, Number, 0, 8}},
        {&FrontRules::spacingWeight,
         {"weight of the spacing",
          "Exponent of the spacing conformity δ(AC)·δ(CB) in the score. 0: the lengths do not "
          "count.",
          "", 6, Ours, Number, 0, 8}},
        {&FrontRules::defer,
         {"deferral",
          "Put a base back once if no candidate passes. Without it, the base is closed with existing nodes "
          "at once.",
          "", 8, Ours, Switch, 0, 1}},
    };
    static_assert(std::size(kRows) == wordsOf<FrontRule>().size());
    return kRows[static_cast<std::size_t>(rule)];
}

} // namespace

double FrontRules::weightedScore(double alpha, double deltaAC, double deltaCB) const {
    return alpha <= 0.0 ? alpha : std::pow(alpha, shapeWeight) * std::pow(deltaAC * deltaCB, spacingWeight);
}

const FrontRuleInfo &frontRuleInfo(FrontRule rule) {
    return rowOf(rule).info;
}

const char *originText(RuleOrigin origin) {
    return origin == RuleOrigin::Lo ? "Lo's" : "ours";
}

double valueOf(const FrontRules &rules, FrontRule rule) {
    return std::visit([&](auto member) { return static_cast<double>(rules.*member); }, rowOf(rule).member);
}

void setValue(FrontRules &rules, FrontRule rule, double value) {
    std::visit([&]<class Value>(Value FrontRules::*member) { rules.*member = static_cast<Value>(value); },
               rowOf(rule).member);
}

std::string valueText(const FrontRules &rules, FrontRule rule) {
    const double value = valueOf(rules, rule);
    switch (frontRuleInfo(rule).kind) {
    case RuleKind::Choice:
        return std::string(wordOf(rules.base));
    case RuleKind::Switch:
        return value != 0.0 ? "on" : "off";
    case RuleKind::Number:
    case RuleKind::Whole:
        break;
    }
    return numberText(value, 12);
}

std::string frontRuleFault(FrontRule rule, double value) {
    const FrontRuleInfo &info = frontRuleInfo(rule);
    const bool whole = info.kind != RuleKind::Number;
    if (value >= info.minimum && value <= info.maximum && (!whole || value == std::floor(value))) {
        return {};
    }
    return std::string("expected a ") + (whole ? "whole number from " : "number from ") + numberText(info.minimum, 7) +
           " to " + numberText(info.maximum, 7) + ", got " + numberText(value, 7);
}

std::vector<FrontRule> changedRules(const FrontRules &rules) {
    std::vector<FrontRule> changed;
    for (const FrontRule rule : valuesOf<FrontRule>()) {
        if (valueOf(rules, rule) != valueOf(FrontRules(), rule)) {
            changed.push_back(rule);
        }
    }
    return changed;
}

std::string changesText(const FrontRules &rules) {
    std::string text;
    for (const FrontRule rule : changedRules(rules)) {
        const std::string unit = frontRuleInfo(rule).unit;
        text += (text.empty() ? "" : ", ") + std::string(frontRuleInfo(rule).name) + ' ' + valueText(rules, rule) +
                (unit.empty() ? "" : " " + unit) + " (default " + valueText(FrontRules(), rule) + ')';
    }
    return text;
}

} // namespace forefront
