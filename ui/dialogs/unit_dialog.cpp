#include "ui/dialogs/unit_dialog.hpp"

#include "core/drawing/commands/convert_unit.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/engine/base/number_text.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace forefront {

namespace {

constexpr float kUnitButton = 96.0F; ///< width, in design pixels

std::string lengthText(double value, LengthUnit unit) {
    return numberText(value, 6) + unitSuffix(unit);
}

/// Tells which parameters for units the expressions have got.
void announceUnits(Shell &context, const Document &before) {
    std::string added;
    for (const Parameter &parameter : context.document.current()->parameters) {
        if (parameterIndex(before.parameters, parameter.name) == before.parameters.size()) {
            added += (added.empty() ? "" : ", ") + parameter.name + " = " + parameter.expression;
        }
    }
    if (!added.empty()) {
        context.log.announce("Expressions name the unit of their parameters: " + added);
    }
}

} // namespace

bool UnitDialog::draw(Shell &context) {
    const LengthUnit before = context.document.current()->unit;
    ui::small(context,
              "Fields, rulers and exported files name the unit. A length typed in another unit, such as 2 in, "
              "is converted.",
              true);
    ImGui::Dummy({0, context.px(4)});
    constexpr std::array<const char *, wordsOf<LengthUnit>().size()> kLabels{"None", "mm", "cm", "m", "km", "in", "ft"};
    int choice = static_cast<int>(unit_);
    if (ui::segmented(context, "dialog/unit/unit", std::span<const char *const>(kLabels), choice)) {
        unit_ = static_cast<LengthUnit>(choice);
    }
    ImGui::Dummy({0, context.px(4)});
    drawEffect(context, before);
    ImGui::Dummy({0, context.px(8)});
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - context.px(2.0 * kUnitButton + 10.0));
    if (ui::button(context, "dialog/unit/cancel", "Cancel", ui::ButtonKind::Plain, true, kUnitButton)) {
        return false;
    }
    ImGui::SameLine(0, context.px(10));
    const bool accepted =
        ui::button(context, "dialog/unit/ok", "OK", ui::ButtonKind::Primary, true, kUnitButton) || ui::enterPressed();
    return !accepted || !accept(context);
}

/// Asks whether the coordinates are scaled, and says what becomes of a length.
void UnitDialog::drawEffect(Shell &context, LengthUnit before) {
    const std::optional<double> factor = conversion(before, unit_);
    if (!factor || unit_ == before) {
        ui::small(context, unit_ == before ? "The drawing is unchanged." : "The coordinates stay as they are.", true);
        return;
    }
    constexpr std::array<const char *, 2> kWays{"Scale the coordinates", "Keep the numbers"};
    int way = scales_ ? 0 : 1;
    if (ui::segmented(context, "dialog/unit/way", std::span<const char *const>(kWays), way)) {
        scales_ = way == 0;
    }
    const std::string old = lengthText(10.0, before);
    ui::small(context,
              scales_ ? old + " becomes " + lengthText(*factor * 10.0, unit_) +
                            ": the drawing has the same size, and "
                            "so have its elements."
                      : old + " becomes " + lengthText(10.0, unit_) + ": the drawing has another size.",
              true);
    if (scales_ && !context.document.current()->formulas.empty()) {
        ui::small(context,
                  "Parameters keep their numbers, in " + std::string(wordOf(before)) +
                      "; the expressions of lengths name that unit.",
                  true);
        ui::mark(context, "dialog/unit/parameters");
    }
    if (scales_ && context.document.current()->spacing.expression) {
        ui::small(context, "The expression of the element size is not converted.", true);
        ui::mark(context, "dialog/unit/expression");
    }
}

bool UnitDialog::accept(Shell &context) const {
    const std::shared_ptr<const Document> before = context.document.current();
    if (unit_ == before->unit) {
        return true;
    }
    Result<Document> next = scales_ ? convertUnit(*before, unit_) : Result<Document>(*before);
    if (next) {
        next->unit = unit_;
    }
    const bool scaled = scales_ && conversion(before->unit, unit_).has_value();
    if (!context.applyCommand(std::move(next), "Change unit to " + std::string(wordOf(unit_)))) {
        return false;
    }
    if (scaled) {
        announceUnits(context, *before);
        context.actions.run("view.fit", context);
    }
    return true;
}

void addUnitAction(ActionRegistry &actions) {
    actions.add({.id = "edit.unit", .menu = "Edit", .title = "Unit\xe2\x80\xa6", .run = [](Shell &c) {
                     c.dialogs.open(std::make_unique<UnitDialog>(c.document.current()->unit));
                 }});
}

} // namespace forefront
