#include "core/drawing/document/document.hpp"
#include "core/engine/mesher/front_rules.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/panels/slider_drag.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/enum_choice.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace forefront {
namespace {

std::string ruleWidget(FrontRule rule, const char *part = "") {
    return "rules/" + std::string(wordOf(rule)) + part;
}

/// Returns the name of a rule as the head of a row: "Search radius".
std::string rowName(FrontRule rule) {
    std::string name = frontRuleInfo(rule).name;
    name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
}

bool isChanged(const FrontRules &rules, FrontRule rule) {
    return valueOf(rules, rule) != valueOf(FrontRules(), rule);
}

/// Returns why a rule has no effect beside the others; empty if it has one.
const char *unusedText(const FrontRules &rules, FrontRule rule) {
    switch (rule) {
    case FrontRule::Seed:
        return rules.base == BaseRule::Random ? "" : "Not used: the order of bases is not random.";
    case FrontRule::NodeClearance:
    case FrontRule::SegmentClearance:
        return rules.withdraw ? "" : "Not used: the withdrawal of C is off.";
    case FrontRule::SecondRadius:
        return rules.defer ? "" : "Not used: the deferral is off.";
    default:
        return "";
    }
}

std::string withUnit(const FrontRules &rules, FrontRule rule) {
    const std::string unit = frontRuleInfo(rule).unit;
    return valueText(rules, rule) + (unit.empty() ? "" : ' ' + unit);
}

std::string tipOf(const FrontRules &rules, FrontRule rule) {
    const FrontRuleInfo &info = frontRuleInfo(rule);
    std::string text = info.meaning;
    text += "\nStep " + std::to_string(info.step) + "; default " + withUnit(FrontRules(), rule);
    if (info.kind == RuleKind::Number || info.kind == RuleKind::Whole) {
        text += ", from " + ui::number(info.minimum, 7) + " to " + ui::number(info.maximum, 7);
    }
    const std::string unused = unusedText(rules, rule);
    return unused.empty() ? text : text + '\n' + unused;
}

/// Changes a rule of the document. Returns false if it has this value already.
bool changeRule(Shell &context, FrontRule rule, double value, std::string_view stroke = {}) {
    Document next = *context.document.current();
    setValue(next.options.rules, rule, value);
    return context.document.apply(std::move(next), std::string("Change rule ") + frontRuleInfo(rule).name, stroke);
}

/// Returns the value for a position of the knob in [0, 1], with few digits.
double valueAtKnob(const FrontRuleInfo &info, double knob) {
    const double perUnit = info.maximum - info.minimum <= 2.0 ? 100.0 : 20.0;
    const double value = info.minimum + knob * (info.maximum - info.minimum);
    return std::clamp(std::round(value * perUnit) / perUnit, info.minimum, info.maximum);
}

/// Edits the rules of the classic method.
class RulesPanel final : public Panel {
  public:
    const char *id() const override { return "rules"; }
    const char *title() const override { return "Rules"; }

    void draw(Shell &context) override {
        const MeshingOptions &options = context.document.current()->options;
        if (options.method != Method::Classic || options.elements != Elements::Triangles) {
            drawOffer(context, options);
            return;
        }
        const FrontRules rules = options.rules;
        drawSummary(context, rules);
        moved_.reset();
        for (const FrontRule rule : valuesOf<FrontRule>()) {
            drawRule(context, rules, rule);
        }
        drag_.follow(context, moved_.has_value(),
                     [&](const char *stroke) { return changeRule(context, moved_->first, moved_->second, stroke); });
    }

  private:
    /// Says why there are no rules to change, and offers the method that has them.
    static void drawOffer(Shell &context, const MeshingOptions &options) {
        const bool triangles = options.elements == Elements::Triangles;
        ui::small(context,
                  triangles ? "The rules are those of the classic method."
                            : "The rules are those of the classic method, which makes triangles.",
                  true);
        ui::mark(context, "rules/offer");
        if (ui::button(context, "rules/classic", triangles ? "Choose Classic" : "Choose Classic with triangles")) {
            Document next = *context.document.current();
            next.options.method = Method::Classic;
            next.options.elements = Elements::Triangles;
            context.document.apply(std::move(next), "Change meshing options");
        }
    }

    static void drawSummary(Shell &context, const FrontRules &rules) {
        const std::size_t changed = changedRules(rules).size();
        ImGui::AlignTextToFramePadding();
        ui::small(context, changed == 0   ? "All rules have their defaults."
                           : changed == 1 ? "1 rule is changed."
                                          : std::to_string(changed) + " rules are changed.");
        ui::mark(context, "rules/summary");
        ui::tooltip(context, changed == 0 ? "Lo's: part of S. H. Lo's method. Ours: the method as published leaves it "
                                            "open; chosen for this program."
                                          : "Changed: " + changesText(rules));
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - context.px(80));
        if (ui::button(context, "rules/reset", "Reset all", ui::ButtonKind::Plain, changed > 0, 80.0F)) {
            Document next = *context.document.current();
            next.options.rules = {};
            context.document.apply(std::move(next), "Reset rules");
        }
        const float half = (ImGui::GetContentRegionAvail().x / context.scale - 6.0F) / 2.0F;
        if (ui::button(context, "rules/open", "Open rules\xe2\x80\xa6", ui::ButtonKind::Plain, true, half)) {
            context.actions.run("file.openRules", context);
        }
        ImGui::SameLine(0, context.px(6));
        if (ui::button(context, "rules/save", "Save rules\xe2\x80\xa6", ui::ButtonKind::Plain, true, half)) {
            context.actions.run("file.saveRules", context);
        }
    }

    void drawRule(Shell &context, const FrontRules &rules, FrontRule rule) {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ImGui::GetStyle().ItemSpacing.x, context.px(2)));
        switch (frontRuleInfo(rule).kind) {
        case RuleKind::Switch:
            drawSwitch(context, rules, rule);
            break;
        case RuleKind::Choice:
            drawName(context, rules, rule);
            drawChoice(context, rules, rule);
            break;
        case RuleKind::Number:
        case RuleKind::Whole:
            drawName(context, rules, rule);
            drawNumber(context, rules, rule);
            break;
        }
        ImGui::PopStyleVar();
    }

    static void drawName(Shell &context, const FrontRules &rules, FrontRule rule) {
        ImGui::AlignTextToFramePadding();
        ImGui::PushFont(isChanged(rules, rule) ? context.fonts.strong : context.fonts.body);
        ImGui::PushStyleColor(ImGuiCol_Text,
                              *unusedText(rules, rule) == '\0' ? context.theme.text : context.theme.faint);
        ImGui::TextUnformatted(rowName(rule).c_str());
        ImGui::PopStyleColor();
        ImGui::PopFont();
        ui::mark(context, ruleWidget(rule, "/name"));
        ui::tooltip(context, tipOf(rules, rule));
        drawOrigin(context, rules, rule);
    }

    /// Writes whose rule it is, and offers to reset one that was changed.
    static void drawOrigin(Shell &context, const FrontRules &rules, FrontRule rule) {
        ImGui::SameLine(0, context.px(6));
        ImGui::AlignTextToFramePadding();
        ui::small(context, originText(frontRuleInfo(rule).origin));
        ui::mark(context, ruleWidget(rule, "/origin"));
        if (!isChanged(rules, rule)) {
            return;
        }
        constexpr float kWidth = 56.0F;
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - context.px(kWidth));
        if (ui::button(context, ruleWidget(rule, "/reset"), "Reset", ui::ButtonKind::Quiet, true, kWidth)) {
            changeRule(context, rule, valueOf(FrontRules(), rule));
        }
        ui::tooltip(context, "Reset to " + withUnit(FrontRules(), rule));
    }

    static void drawSwitch(Shell &context, const FrontRules &rules, FrontRule rule) {
        bool on = valueOf(rules, rule) != 0.0;
        ImGui::PushFont(isChanged(rules, rule) ? context.fonts.strong : context.fonts.body);
        const bool changed = ui::checkbox(context, ruleWidget(rule), rowName(rule), on);
        ImGui::PopFont();
        ui::tooltip(context, tipOf(rules, rule));
        drawOrigin(context, rules, rule);
        if (changed) {
            changeRule(context, rule, on ? 1.0 : 0.0);
        }
    }

    static void drawChoice(Shell &context, const FrontRules &rules, FrontRule rule) {
        BaseRule order = rules.base;
        ImGui::BeginGroup();
        const bool changed = ui::segmented(context, ruleWidget(rule), order);
        ImGui::EndGroup();
        ui::tooltip(context, tipOf(rules, rule));
        if (changed) {
            changeRule(context, rule, static_cast<double>(order));
        }
    }

    void drawNumber(Shell &context, const FrontRules &rules, FrontRule rule) {
        constexpr float kFieldWidth = 60.0F, kUnitWidth = 30.0F, kRuleGap = 6.0F;
        const FrontRuleInfo &info = frontRuleInfo(rule);
        double value = valueOf(rules, rule);
        if (info.kind == RuleKind::Number) {
            double knob = (value - info.minimum) / (info.maximum - info.minimum);
            const float width =
                ImGui::GetContentRegionAvail().x / context.scale - kFieldWidth - kUnitWidth - 2.0F * kRuleGap;
            if (ui::thinSlider(context, ruleWidget(rule, "/slider"), knob, "", std::max(24.0F, width), 0.0F)) {
                moved_.emplace(rule, valueAtKnob(info, knob));
            }
            ui::tooltip(context, "Drag: the live mesh follows. One drag is one undo step; Esc takes it back.");
            ImGui::SameLine(0, context.px(kRuleGap));
        }
        const std::string name = ruleWidget(rule);
        if (ui::inputNumber(context, name, value, kFieldWidth)) {
            const bool good = info.kind == RuleKind::Whole
                                  ? ui::checkWhole(context, name, value, info.minimum, info.maximum)
                                  : ui::checkRange(context, name, value, info.minimum, info.maximum);
            if (good) {
                changeRule(context, rule, value);
            }
        }
        ui::tooltip(context, tipOf(rules, rule));
        if (*info.unit != '\0') {
            ImGui::SameLine(0, context.px(kRuleGap));
            ImGui::AlignTextToFramePadding();
            ui::small(context, info.unit);
        }
    }

    SliderDrag drag_{"rule slider"};
    std::optional<std::pair<FrontRule, double>>
        moved_; ///< the rule whose slider has moved in this frame, and its value
};

} // namespace

std::unique_ptr<Panel> makeRulesPanel() {
    return std::make_unique<RulesPanel>();
}

} // namespace forefront
