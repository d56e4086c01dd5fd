#include "ui/dialogs/operation_dialog.hpp"

#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"

#include <imgui.h>

#include <algorithm>

namespace forefront {
namespace {

constexpr double kLabelWidth = 110.0; ///< width of the labels, in design pixels

} // namespace

OperationDialog::OperationDialog(Operation operation, Shell &context)
    : operation_(std::move(operation)), start_(context.document.current()), selection_(context.selection),
      stroke_(std::string(operation_.id) + ' ' + std::to_string(context.document.revision())) {
    for (const OperationField &field : operation_.fields) {
        values_.push_back(field.value);
    }
    formulas_.resize(values_.size());
    const auto number = std::find_if(operation_.fields.begin(), operation_.fields.end(),
                                     [](const OperationField &f) { return f.kind == OperationField::Kind::Number; });
    if (number != operation_.fields.end()) {
        context.widgets.fields.request(widget(static_cast<std::size_t>(number - operation_.fields.begin())));
    }
    context.document.endStroke();
    show(context);
}

std::string OperationDialog::widget(std::size_t index) const {
    return std::string("dialog/") + operation_.id + '/' + operation_.fields[index].id;
}

/// Makes the result the current document, as part of a stroke that can be abandoned.
void OperationDialog::show(Shell &context) {
    dismiss(context);
    made_.clear();
    fault_.clear();
    Result<Document> next = operation_.run(*start_, selection_, values_, &made_);
    if (next) {
        followed_ = operation_.follow && operation_.follow(*next, selection_, formulas_);
        context.document.apply(*std::move(next), operation_.title, stroke_);
    } else {
        const Diagnostic &fault = next.faults().front();
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
}

bool OperationDialog::drawField(Shell &context, std::size_t index) {
    const OperationField &field = operation_.fields[index];
    const std::string name = widget(index);
    double &value = values_[index];
    ui::rowLabel(context, field.kind == OperationField::Kind::Flag ? "" : field.label, kLabelWidth);
    bool changed = false;
    switch (field.kind) {
    case OperationField::Kind::Number:
        changed = ui::inputExpression(context, name, value, formulas_[index]);
        break;
    case OperationField::Kind::Choice: {
        int choice = static_cast<int>(value);
        changed = ui::segmented(context, name, field.choices, choice);
        value = choice;
        break;
    }
    case OperationField::Kind::Flag: {
        bool on = value != 0.0;
        changed = ui::checkbox(context, name, field.label, on);
        value = on ? 1.0 : 0.0;
        break;
    }
    }
    if (*field.tooltip != '\0') {
        ui::tooltip(context, field.tooltip);
    }
    return changed;
}

bool OperationDialog::draw(Shell &context) {
    bool changed = false;
    for (std::size_t k = 0; k < operation_.fields.size(); ++k) {
        changed = drawField(context, k) || changed;
    }
    if (changed) {
        show(context);
    }
    const std::string name = std::string("dialog/") + operation_.id;
    if (!fault_.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, context.theme.bad);
        ui::small(context, fault_, true);
        ImGui::PopStyleColor();
        ui::mark(context, name + "/fault");
    }
    const bool typed = std::any_of(formulas_.begin(), formulas_.end(), [](const auto &text) { return !text.empty(); });
    if (typed && !followed_) {
        ui::small(context, "Parameters are evaluated once here");
        ui::mark(context, name + "/once");
    }
    ImGui::Dummy({0, context.px(6)});
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - context.px(218));
    if (ui::button(context, name + "/cancel", "Cancel", ui::ButtonKind::Plain, true, 104.0F)) {
        dismiss(context);
        return false;
    }
    ImGui::SameLine(0, context.px(10));
    const bool ok = ui::button(context, name + "/ok", "OK", ui::ButtonKind::Primary, fault_.empty(), 104.0F);
    if (fault_.empty() && (ok || ImGui::IsKeyPressed(key::kEnter, false))) {
        accept(context);
        return false;
    }
    return true;
}

} // namespace forefront
