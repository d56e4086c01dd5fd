#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/front/base_rule.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

/// Minimum clearance of the ideal point from Γ, in ρ. Nearer nodes leave elements that rounding cannot tell from flat
/// ones, and no bound on their number.
inline constexpr double kLeastClearance = 0.3;

/// The rules of the classic method that can be changed. frontRuleInfo() describes each one and bounds it; any
/// combination of values within the bounds gives a valid mesh. Other methods and quadrilaterals do not use them.
struct FrontRules {
    BaseRule base = BaseRule::Shortest;
    std::uint32_t seed = 1;     ///< of BaseRule::Random
    double minRho = 0.55;       ///< minimum of ρ, in |AB|
    double maxRho = 2.0;        ///< maximum of ρ, in |AB|
    double rhoAtC = 0.5;        ///< share of ρ near C in the mean; the rest is ρ at the midpoint of AB
    double minHeight = 0.5;     ///< minimum height of C above AB, in |AB|
    double radius = 1.2;        ///< of the first search around C, in ρ
    double secondRadius = 1.75; ///< of the search for a base that was deferred, in ρ
    bool withdraw = true;       ///< withdraw C where Γ is nearer than the clearances; else only within kLeastClearance
    double nodeClearance = 0.65;   ///< minimum distance of C from nodes of Γ, in ρ
    double segmentClearance = 0.5; ///< minimum distance of C from segments of Γ, in ρ
    double shapeWeight = 1.0;      ///< exponent of α(ABC) in the score
    double spacingWeight = 1.0;    ///< exponent of δ(AC)·δ(CB) in the score
    bool defer = true;             ///< put a base back once if no candidate passes; otherwise close it at once

    /// Returns the score of a candidate: α^shapeWeight · (δ(AC)·δ(CB))^spacingWeight. Candidates on the meshed side
    /// have α ≤ 0 and keep it, so that they stay last.
    double score(double alpha, double deltaAC, double deltaCB) const {
        return shapeWeight == 1.0 && spacingWeight == 1.0 ? alpha * deltaAC * deltaCB
                                                          : weightedScore(alpha, deltaAC, deltaCB);
    }

    friend bool operator==(const FrontRules &, const FrontRules &) = default;

  private:
    double weightedScore(double alpha, double deltaAC, double deltaCB) const;
};

/// A rule of the classic method.
enum class FrontRule : std::uint8_t {
    Base,
    Seed,
    MinRho,
    MaxRho,
    RhoAtC,
    MinHeight,
    Radius,
    SecondRadius,
    Withdraw,
    NodeClearance,
    SegmentClearance,
    ShapeWeight,
    SpacingWeight,
    Defer
};

/// The words are the members of "rules" in projects, lessons and files of rules.
template <>
struct EnumWords<FrontRule> {
    static constexpr auto kLast = FrontRule::Defer;
    static constexpr std::array<std::string_view, 14> kList = {
        "base",         "seed",     "minRho",        "maxRho",           "rhoAtC",      "minHeight",     "radius",
        "secondRadius", "withdraw", "nodeClearance", "segmentClearance", "shapeWeight", "spacingWeight", "defer"};
};

/// Who chose a rule and its default.
enum class RuleOrigin : std::uint8_t {
    Lo,  ///< part of S. H. Lo's method as published or as generally described
    Ours ///< chosen for this program; the published description leaves it open
};

/// The kind of values that a rule has.
enum class RuleKind : std::uint8_t {
    Number,
    Whole,
    Switch, ///< 0 or 1
    Choice  ///< a BaseRule
};

/// The description of a rule. Words and switches are numbers here: the place of the word, 0 or 1.
struct FrontRuleInfo {
    const char *name;    ///< "search radius"
    const char *meaning; ///< a sentence for help and tooltips
    const char *unit;    ///< "ρ", "|AB|" or empty
    int step;            ///< of the ten that it belongs to
    RuleOrigin origin;
    RuleKind kind;
    double minimum, maximum;
};

/// Returns the description of a rule.
const FrontRuleInfo &frontRuleInfo(FrontRule rule);
/// Returns who chose a rule, as text: "Lo's" or "ours".
const char *originText(RuleOrigin origin);
/// Returns the value of a rule as a number.
double valueOf(const FrontRules &rules, FrontRule rule);
/// Sets a rule to a value that has no fault.
void setValue(FrontRules &rules, FrontRule rule, double value);
/// Returns the value of a rule as text: "1.2", "on", "oldest".
std::string valueText(const FrontRules &rules, FrontRule rule);
/// Returns the error in the value of a rule, "expected a number from 0.2 to 5, got 7"; empty if it is valid.
std::string frontRuleFault(FrontRule rule, double value);
/// Returns the rules that differ from their defaults, in order.
std::vector<FrontRule> changedRules(const FrontRules &rules);
/// Returns the rules that differ from their defaults as text: "search radius 2 ρ (default 1.2), deferral off (default
/// on)"; empty if there are none.
std::string changesText(const FrontRules &rules);

} // namespace forefront
