#include "ui/panels/form.hpp"

#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"
#include "ui/workspace/workspace.hpp"

#include <imgui.h>

namespace forefront::form {

void label(Workspace &context, const char *text) {
    ui::rowLabel(context, text, kLabel);
}

bool number(Workspace &context, const std::string &name, const char *text, double &value,
            const ui::FieldAddress &address) {
    label(context, text);
    return ui::inputNumber(context, name, value, -1.0F, address);
}

float halfWidth(const Workspace &context) {
    return (ImGui::GetContentRegionAvail().x - context.px(6)) / (2.0F * context.scale);
}

float wordBefore(Workspace &context, const char *word, float width) {
    ImGui::AlignTextToFramePadding();
    ui::muted(context, word);
    ui::markCaption(context, word);
    const float field = width - ImGui::GetItemRectSize().x / context.scale - 4.0F;
    ImGui::SameLine(0, context.px(4));
    return field;
}

bool optionalField(Workspace &context, const std::string &name, std::optional<double> &value, const char *hint,
                   float width, const ui::FieldAddress &address) {
    return ui::inputOptional(context, name, value, hint, width, address);
}

bool pair(Workspace &context, const std::string &name, const char *text, Vec2 &value, const PairAddress &address) {
    label(context, text);
    return ui::inputPoint(context, name, value, halfWidth(context), address.x, address.y);
}

bool text(Workspace &context, const std::string &name, const char *text, std::string &value, const char *hint) {
    label(context, text);
    return ui::inputName(context, name, value, hint);
}

bool tag(Workspace &context, const std::string &name, const char *text, std::int32_t &value,
         const std::string &shownName, std::optional<std::string> &rename) {
    label(context, text);
    double number = value;
    const bool changed = ui::inputNumber(context, name, number, 48.0F) && ui::checkTag(context, name, number);
    ui::tooltip(context, "Tag, a whole number: mesh files mark the part with it");
    ImGui::SameLine(0, context.px(6));
    std::string typed = shownName;
    if (ui::inputName(context, name + "/name", typed, "name", -1.0F, true) && typed != shownName) {
        rename = typed;
    }
    ui::tooltip(context, "Name of the part in mesh files, for example for loads and materials");
    if (changed) {
        value = static_cast<std::int32_t>(number);
    }
    return changed;
}

} // namespace forefront::form
