#include "ui/tools/common/tool_options.hpp"

#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/names/name_commands.hpp"
#include "core/drawing/names/region_commands.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/parse_number.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/number_field.hpp"
#include "ui/workspace/workspace.hpp"

#include <imgui.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>

namespace forefront {

namespace {

/// Returns the tag for a typed number or name; names a free tag if nothing has the name. Reports what is neither.
std::optional<std::int32_t> typedTag(Workspace &context, const std::string &typed) {
    const std::shared_ptr<const Document> document = context.document.current();
    const std::string text(trimmed(typed));
    if (const std::optional<double> number = parseNumber(text)) {
        if (*number >= 1.0 && *number <= ui::kMaxTag && *number == std::floor(*number)) {
            return static_cast<std::int32_t>(*number);
        }
    } else if (const std::optional<std::int32_t> known = boundaryTagNamed(*document, text)) {
        return known;
    } else if (!text.empty()) {
        const std::int32_t tag = freeBoundaryTag(*document);
        const bool named = context.applyCommand(setBoundaryName(*document, tag, text), "Name boundary");
        return named ? std::optional(tag) : std::nullopt;
    }
    const std::string reason = "expected a tag from 1 to 1000000000 or a name, got '" + text + "'";
    ui::refuseEntry(context, "options/tag",
                    error("bad-tag", reason, "enter a number such as 3, or a name such as inlet"), reason);
    return std::nullopt;
}

} // namespace

void drawTagOption(Workspace &context, ui::Flow &flow, EditState &state, ShapeUse use, const char *tooltip) {
    flow.item("tag");
    flow.label("Tag");
    const bool boundary = use == ShapeUse::Boundary;
    std::optional<std::int32_t> &chosen = boundary ? state.boundaryTag : state.constraintTag;
    const std::string automatic = std::to_string(state.tagOfNext(use, *context.document.current()));
    const std::optional<std::string> typed =
        ui::inputChecked(context, "options/tag", chosen ? std::to_string(*chosen) : "", automatic, 64.0F);
    ui::tooltip(context, std::string(tooltip) + ": a number, a name in use, or a new name" +
                             (boundary ? "; while it is empty, each hole gets a tag of its own" : ""));
    if (typed && trimmed(*typed).empty()) {
        chosen.reset();
    } else if (const std::optional<std::int32_t> entered = typed ? typedTag(context, *typed) : std::nullopt) {
        chosen = entered;
    }
    ImGui::SameLine();
    ui::muted(context, boundaryName(context.document.current()->boundaryNames,
                                    state.tagOfNext(use, *context.document.current())) +
                           (boundary && !chosen ? ", holes apart" : ""));
}

namespace {

bool drawNumber(Workspace &context, ui::Flow &flow, const char *name, const char *label, double &value,
                const char *tooltip, bool zero, LengthUnit unit = LengthUnit::None) {
    flow.item(name);
    flow.label(label);
    double entered = value;
    const bool changed =
        ui::inputNumber(context, name, entered, 76.0F, {}, unit) && ui::checkPositive(context, name, entered, zero);
    ui::tooltip(context, tooltip);
    if (changed) {
        value = entered;
    }
    return changed;
}

} // namespace

bool drawSizeOption(Workspace &context, ui::Flow &flow, const char *name, const char *label, double &value,
                    const char *tooltip, LengthUnit unit) {
    return drawNumber(context, flow, name, label, value, tooltip, false, unit);
}

bool drawOptionalSizeOption(Workspace &context, ui::Flow &flow, const char *name, const char *label,
                            std::optional<double> &value, const char *hint, const char *tooltip) {
    flow.item(name);
    flow.label(label);
    std::optional<double> entered = value;
    const LengthUnit unit = context.document.current()->unit;
    const bool changed = ui::inputOptional(context, name, entered, hint, 76.0F, {}, unit) &&
                         (!entered || ui::checkPositive(context, name, *entered));
    ui::tooltip(context, tooltip);
    if (changed) {
        value = entered;
    }
    return changed;
}

bool drawFormulaOption(Workspace &context, ui::Flow &flow, const char *name, const char *label, double &value,
                       std::string &formula, const char *tooltip, bool zero, LengthUnit unit) {
    if (const Result<double> now = evaluateFormula(*context.document.current(), formula); now && !formula.empty()) {
        value = *now;
    } else {
        formula.clear(); // its parameters are gone
    }
    flow.item(name);
    flow.label(label);
    double entered = value;
    std::string text = formula;
    const bool changed = ui::inputExpression(context, name, entered, text, 76.0F, unit) &&
                         ui::checkPositive(context, name, entered, zero);
    ui::tooltip(context, tooltip);
    if (changed) {
        value = entered;
        formula = text;
    }
    return changed;
}

bool drawLengthOption(Workspace &context, ui::Flow &flow, const char *name, const char *label, double &value,
                      const char *tooltip, LengthUnit unit) {
    return drawNumber(context, flow, name, label, value, tooltip, true, unit);
}

} // namespace forefront
