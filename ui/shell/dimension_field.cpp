#include "core/drawing/commands/typed_size.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/place_formulas.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/fault_text.hpp"
#include "ui/widgets/parse_number.hpp"
#include "ui/widgets/popup_style.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/typed_length.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront::shell {
namespace {

constexpr double kDimensionWidth = 160.0; ///< design pixels

/// Keeps the text that was refused in the field, with the focus and the reason.
void refuseDimension(Shell &context, const Diagnostics &faults) {
    DimensionEntry &entry = context.dimensionEntry;
    context.log.keep(faults);
    entry.fault = faults.front().message;
    context.widgets.fields.request("dimension/value");
    context.animate();
}

/// Gives the parameter behind a dimension the value that was typed: the link between them stays.
void setBehind(Shell &context, std::size_t parameter, const std::string &typed) {
    const std::shared_ptr<const Document> document = context.document.current();
    std::vector<Parameter> parameters = document->parameters;
    const std::string name = parameters[parameter].name;
    parameters[parameter].expression = typed;
    Result<Document> next = setParameters(*document, std::move(parameters));
    if (!next) {
        refuseDimension(context, next.faults());
    } else if (context.applyCommand(std::move(next), "Change parameter " + name + " to " + typed)) {
        context.log.announce("Set the parameter " + name + " to " + typed);
        context.dimensionEntry.close();
        context.animate();
    }
}

/// Sets the value and the expression of the dimension as one step, and closes the field.
void finishDimension(Shell &context) {
    DimensionEntry &entry = context.dimensionEntry;
    const std::shared_ptr<const Document> document = context.document.current();
    const std::uint32_t id = *entry.constraint;
    const NumberAddress address{NumberOwner::ofConstraint(id), Quantity::Value};
    const LengthUnit unit = lengthPower(*document, address) == 1 ? document->unit : LengthUnit::None;
    const std::string typed = inUnit(std::string(trimmed(entry.text)), unit);
    const std::optional<double> number = parseNumber(typed);
    const Result<double> value = number ? Result<double>(*number) : evaluateFormula(*document, typed);
    if (!value) {
        const std::string reason = unitFault(*document, typed);
        refuseDimension(context, reason.empty() ? value.faults() : error("bad-number", reason));
        return;
    }
    const std::optional<std::size_t> parameter = number ? parameterBehind(*document, id) : std::nullopt;
    if (parameter && entry.edited) {
        setBehind(context, *parameter, typed);
        return;
    }
    Result<Document> next = setDimension(*document, id, *value);
    if (!next) {
        refuseDimension(context, next.faults());
        return;
    }
    next = setFormula(*std::move(next), address, usesNames(typed) ? typed : std::string());
    const std::string label = (entry.stroke.empty() ? "Change " : "Add ") + findConstraint(*document, id)->name;
    if (const Result<Document> checked = applyFormulas(*next); !checked) {
        refuseDimension(context, checked.faults());
        return;
    }
    if (context.applyCommand(std::move(next), label, entry.stroke)) {
        context.document.endStroke();
        entry.close();
        context.animate();
    }
}

void drawDimensionEntry(Shell &context, const SketchConstraint &constraint) {
    DimensionEntry &entry = context.dimensionEntry;
    if (entry.frames++ == 0) {
        context.widgets.fields.request("dimension/value");
    }
    ui::small(context, constraint.name);
    const std::string before = entry.text;
    const bool entered = ui::inputText(context, "dimension/value", entry.text, "4.5 or w/2",
                                       static_cast<float>(kDimensionWidth), true, false, true);
    if (std::exchange(entry.restore, false)) { // undo, where Dear ImGui has forgotten what was typed
        entry.text = entry.initial;
        entry.fault.clear();
        entry.edited = false;
        context.widgets.fields.request("dimension/value");
        context.animate();
    } else if (entry.text != before) {
        entry.edited = true;
        entry.fault.clear();
        context.animate();
    }
    if (!entry.fault.empty()) {
        ui::faultText(context, entry.fault);
        ui::mark(context, "dimension/fault");
    }
    if (imgui::keyPressed(key::kEscape, false)) {
        entry.close();
    } else if (entered) {
        finishDimension(context);
    }
}

} // namespace

void drawDimensionField(Shell &context, const PixelRect &canvas) {
    DimensionEntry &entry = context.dimensionEntry;
    if (!entry.constraint) {
        return;
    }
    const std::shared_ptr<const Document> document = context.document.current();
    const SketchConstraint *const constraint = findConstraint(*document, *entry.constraint);
    if (constraint == nullptr || context.dialogs.any() || entry.revision != context.document.revision()) {
        entry.close(); // its dimension may be gone
        return;
    }
    const auto *const last = context.widgets.find("dimension");
    const double width = last != nullptr ? last->rect.width : static_cast<double>(context.px(kDimensionWidth + 24.0));
    const double height = last != nullptr ? last->rect.height : static_cast<double>(context.px(80.0));
    const auto within = [](double at, double low, double room, double size) {
        return static_cast<float>(std::clamp(at, low, std::max(low, low + room - size)));
    };
    ImGui::SetNextWindowPos(
        {within(entry.at.x, canvas.x, canvas.width, width), within(entry.at.y, canvas.y, canvas.height, height)});
    {
        const ui::PopupStyle style(context, 12, 10, 8);
        ImGui::Begin("##dimension", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize);
    }
    ui::markWindow(context, "dimension");
    const bool elsewhere =
        entry.frames > 1 && !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows) &&
        (ImGui::IsMouseClicked(ImGuiMouseButton_Left) || ImGui::IsMouseClicked(ImGuiMouseButton_Right));
    if (elsewhere && entry.edited) {
        finishDimension(context); // as in every other field
    } else if (elsewhere) {
        entry.close();
    } else {
        drawDimensionEntry(context, *constraint);
    }
    ImGui::End();
}

} // namespace forefront::shell
