#include "core/drawing/commands/typed_size.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "ui/parts/shell.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/widgets/popup_style.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace forefront::shell {
namespace {

/// Returns what the button does, such as "Set Length 1 to 7".
std::string offerOf(const Document &document, const DimensionChange &change) {
    const std::string value = " to " + ui::number(change.value, 6);
    if (const std::optional<std::size_t> parameter = parameterBehind(document, change.constraint)) {
        return "Set parameter " + document.parameters[*parameter].name + value;
    }
    const auto formula = document.formulas.find({NumberOwner::ofConstraint(change.constraint), Quantity::Value});
    return "Set " + findConstraint(document, change.constraint)->name + value +
           (formula == document.formulas.end() ? "" : ", without its expression " + formula->second);
}

} // namespace

void drawFieldOffer(Shell &context) {
    const std::optional<DimensionChange> change = context.fieldFault.change;
    const WidgetRegistry::Widget *const note = context.widgets.find("fieldnote");
    const std::shared_ptr<const Document> document = context.document.current();
    if (!change || note == nullptr || context.fieldFault.revision != context.document.revision() ||
        findConstraint(*document, change->constraint) == nullptr) {
        return;
    }
    const WidgetRegistry::Widget *const field = context.widgets.find("fieldnote/field");
    const WidgetRegistry::Widget *const last = context.widgets.find("fieldoffer");
    const double height = last != nullptr ? last->rect.height : static_cast<double>(context.px(36.0));
    const bool above = field != nullptr && field->rect.y > note->rect.y; // so is the note, for want of room below
    ImGui::SetNextWindowPos({static_cast<float>(note->rect.x),
                             static_cast<float>(above ? note->rect.y - height : note->rect.y + note->rect.height)});
    {
        const ui::PopupStyle style(context, 6, 6, 4);
        ImGui::Begin("##fieldoffer", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoFocusOnAppearing);
    }
    ui::markWindow(context, "fieldoffer");
    // The field loses the focus by the press, and is refused once more: the note is not there for a frame, so that the
    // button would not see the release.
    const bool released = ui::button(context, "fieldoffer/change", offerOf(*document, *change));
    const bool taken = released || ImGui::IsItemClicked(ImGuiMouseButton_Left);
    ImGui::End();
    if (taken) {
        const std::string name = findConstraint(*document, change->constraint)->name;
        context.applyCommand(changeDimension(*document, *change), "Change " + name);
        context.fieldFault.change.reset();
        context.animate();
    }
}

} // namespace forefront::shell
