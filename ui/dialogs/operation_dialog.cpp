#include "ui/dialogs/operation_dialog.hpp"

#include "ui/parts/shell.hpp"
#include "ui/widgets/fault_text.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/announce_changes.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>
#include <utility>

namespace forefront {
namespace {

constexpr float kOperationField = 72.0F, kOperationButton = 84.0F; ///< in design pixels

} // namespace

OperationDialog::OperationDialog(Operation operation, Shell &context)
    : operation_(std::move(operation)), start_(context.document.current()), selection_(context.selection),
      stroke_(std::string(operation_.id) + ' ' + std::to_string(context.document.revision())) {
    for (const OperationField &field : operation_.fields) {
        entries_.values.push_back(field.value);
    }
    entries_.formulas.resize(entries_.values.size());
    const auto number = std::find_if(operation_.fields.begin(), operation_.fields.end(),
                                     [](const OperationField &f) { return f.kind == OperationField::Kind::Number; });
    if (number != operation_.fields.end()) {
        context.widgets.fields.request(widget(static_cast<std::size_t>(number - operation_.fields.begin())));
    }
    context.document.endStroke();
    show(context, entries_);
}

std::string OperationDialog::widget(std::size_t index) const {
    return std::string("dialog/") + operation_.id + '/' + operation_.fields[index].id;
}

OperationDialog::Entries OperationDialog::entriesBeingTyped(const Shell &context) const {
    Entries entries = entries_;
    for (std::size_t k = 0; k < operation_.fields.size(); ++k) {
        if (std::optional<ui::TypedNumber> typed = ui::numberBeingTyped(context, widget(k))) {
            entries.values[k] = typed->value;
            entries.formulas[k] = std::move(typed->formula);
        }
    }
    return entries;
}

/// Makes the result the current document, as part of a stroke that can be abandoned.
void OperationDialog::show(Shell &context, Entries entries) {
    shown_ = std::move(entries);
    dismiss(context);
    made_.clear();
    fault_.clear();
    Result<Document> next = operation_.run(*start_, selection_, shown_.values, &made_);
    Status faults;
    if (next) {
        followed_ = operation_.follow && operation_.follow(*next, selection_, shown_.formulas);
        faults = context.document.tryApply(*std::move(next), operation_.title, stroke_);
        if (faults.empty() && operation_.constrain != nullptr) {
            faults = context.document.tryApply(operation_.constrain(*start_, *context.document.current()),
                                               operation_.title, stroke_);
        }
    } else {
        faults = next.faults();
    }
    if (!faults.empty()) {
        const Diagnostic &fault = faults.front();
        fault_ = fault.advice.empty() ? fault.message : fault.message + "; " + fault.advice;
    }
    context.animate();
}

void OperationDialog::dismiss(Shell &context) {
    if (context.document.current() != start_) {
        context.document.abandonStroke(stroke_);
    }
}

void OperationDialog::accept(Shell &context) {
    context.document.endStroke();
    if (!made_.empty()) {
        context.selection = made_;
    }
    context.selection.prune(*context.document.current());
    announceLosses(context, *start_);
    announceChangedDimensions(context, *start_);
}

void OperationDialog::drawField(Shell &context, std::size_t index) {
    const OperationField &field = operation_.fields[index];
    const std::string name = widget(index);
    double &value = entries_.values[index];
    if (field.kind != OperationField::Kind::Flag) {
        ImGui::AlignTextToFramePadding();
        ui::muted(context, field.label);
        ImGui::SameLine(0, context.px(6));
    }
    switch (field.kind) {
    case OperationField::Kind::Number:
        ui::inputExpression(context, name, value, entries_.formulas[index], kOperationField,
                            field.isLength ? context.document.current()->unit : LengthUnit::None);
        break;
    case OperationField::Kind::Choice: {
        int choice = static_cast<int>(value);
        ui::segmented(context, name, field.choices, choice, 76.0F * static_cast<float>(field.choices.size()));
        value = choice;
        break;
    }
    case OperationField::Kind::Flag: {
        bool on = value != 0.0;
        ui::checkbox(context, name, field.label, on);
        value = on ? 1.0 : 0.0;
        break;
    }
    }
    if (*field.tooltip != '\0') {
        ui::tooltip(context, field.tooltip);
    }
}

void OperationDialog::drawRemarks(Shell &context, ui::Flow &flow) {
    const std::string name = std::string("dialog/") + operation_.id;
    if (!fault_.empty()) {
        flow.item("fault");
        ui::faultText(context, fault_);
        ui::mark(context, name + "/fault");
    }
    const bool typed =
        std::any_of(shown_.formulas.begin(), shown_.formulas.end(), [](const auto &text) { return !text.empty(); });
    if (typed && !followed_) {
        flow.item("once");
        ImGui::AlignTextToFramePadding();
        ui::small(context, "Parameters are evaluated once here");
        ui::mark(context, name + "/once");
    }
}

bool OperationDialog::drawButtons(Shell &context, bool enter) {
    const std::string name = std::string("dialog/") + operation_.id;
    if (ui::button(context, name + "/cancel", "Cancel", ui::ButtonKind::Plain, true, kOperationButton)) {
        dismiss(context);
        return false;
    }
    ui::tooltip(context, "Esc");
    ImGui::SameLine(0, context.px(8));
    const bool ok = ui::button(context, name + "/ok", "OK", ui::ButtonKind::Primary, fault_.empty(), kOperationButton);
    ui::tooltip(context, "Enter");
    if (!ok && !enter) {
        return true;
    }
    const bool refused = ui::showsFault(context, name + '/');
    if (refused || !fault_.empty()) {
        FieldFocus &fields = context.widgets.fields;
        fields.request(refused ? context.fieldFault.field : fields.committed); // to type another number
        return true;
    }
    accept(context);
    return false;
}

bool OperationDialog::draw(Shell &context) {
    const bool enter = ui::enterPressed();
    ui::Flow flow(context, ImGui::GetContentRegionAvail().x, context.px(14));
    flow.item("title");
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(context.fonts.strong);
    ImGui::TextUnformatted(operation_.title);
    ImGui::PopFont();
    for (std::size_t k = 0; k < operation_.fields.size(); ++k) {
        flow.item(operation_.fields[k].id);
        drawField(context, k);
    }
    if (Entries entries = entriesBeingTyped(context); entries != shown_) {
        show(context, std::move(entries));
    }
    flow.item("buttons");
    const bool stays = drawButtons(context, enter);
    drawRemarks(context, flow);
    return stays;
}

} // namespace forefront
