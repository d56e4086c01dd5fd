#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/field_frame.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

namespace forefront::ui {

namespace {

/// For ImGui::IsWindowFocused().
constexpr int kWindowWithoutPopups = ImGuiFocusedFlags_ChildWindows | ImGuiFocusedFlags_NoPopupHierarchy;

/// Notes that the field just drawn was clicked with the right button, and which part of its text is selected.
void noteRightClick(FieldFocus &fields, std::string_view name, const std::string &text, ImGuiID id) {
    if (!ImGui::IsItemHovered() || !ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        return;
    }
    std::size_t begin = 0, end = text.size();
    const ImGuiInputTextState *const state = ImGui::GetActiveID() == id ? ImGui::GetInputTextState(id) : nullptr;
    if (state != nullptr && state->HasSelection()) {
        const auto [low, high] = imgui::selectedBytes(*state);
        begin = std::min(end, low);
        end = std::min(end, high);
    }
    fields.clicked = {std::string(name), text, {}, begin, end};
}

struct Drawn {
    bool returned = false;  ///< returned by Dear ImGui
    bool replaced = false;  ///< a command of the menu of the field has given it another text
    bool held = false;      ///< the field had the focus in the last frame, so its text was typed
    bool holds = false;     ///< the field has the focus now
    bool abandoned = false; ///< Esc, or a second click elsewhere, gave up its text
};

/// Forgets the undo history of a field that was left: its changes now belong to the history of the document. Not of one
/// that takes the focus back, with its caret.
void forgetLeft(ImGuiID id, bool returns) {
    ImGuiInputTextState *const state = ImGui::GetInputTextState(id);
    if (state != nullptr && ImGui::GetActiveID() != id && !returns) {
        state->ID = 0;
    }
}

/// Gives the focus back to a field that lost it in the last frame, with its caret and its undo history. Returns false
/// if Dear ImGui has forgotten them meanwhile.
bool takeBack(ImGuiID id) {
    if (ImGui::GetInputTextState(id) == nullptr) {
        return false;
    }
    ImGuiWindow *const window = ImGui::GetCurrentWindow();
    ImGui::SetActiveID(id, window);
    ImGui::SetFocusID(id, window);
    ImGui::FocusWindow(window);
    return true;
}

bool tabPressed() {
    return imgui::keyPressed(key::kTab) && !ImGui::GetIO().KeyCtrl && !ImGui::GetIO().KeyAlt;
}

/// Draws a text field and adds it to the order in which Tab visits fields.
Drawn drawField(WidgetContext &context, std::string_view name, std::string &value, std::string_view hint, float width,
                ImGuiInputTextFlags flags, bool focus) {
    FieldFocus &fields = context.widgets.fields;
    ImGui::PushID(name.data(), name.data() + name.size());
    const ImGuiID id = ImGui::GetID("##text");
    ImGui::SetNextItemWidth(width < 0.0F ? -1.0F : context.px(static_cast<double>(width)));
    const FieldFocus::Refused *const refused = fields.refused(name);
    const bool returns = refused != nullptr && refused->returns;
    forgetLeft(id, returns);
    if (returns) {
        if (takeBack(id)) {
            fields.entry = refused->entry;
        } else {
            fields.request(name);
        }
        fields.returned();
        context.animate();
    }
    if (focus) {
        fields.request(name);
    }
    if (fields.takes(name)) {
        ImGui::SetKeyboardFocusHere();
        context.animate();
    }
    Drawn drawn{.held = ImGui::GetActiveID() == id};
    {
        const imgui::RedoByShiftZ redo;
        const FieldFrame frame(context);
        drawn.returned = ImGui::InputTextWithHint("##text", std::string(hint).c_str(), &value, flags);
    }
    ImGui::PopID();
    mark(context, name);
    noteRightClick(fields, name, value, id);
    if (std::optional<std::string> text = fields.replacement(name)) {
        value = *std::move(text);
        drawn.replaced = true;
        context.animate();
    }
    if (const ImGuiWindow *window = ImGui::GetCurrentWindowRead(); !window->SkipItems) {
        fields.drawn(name, window->RootWindow->ID);
    }
    if (ImGui::GetActiveID() == id) {
        fields.gotFocus(name);
        const bool tab = tabPressed();
        if (tab) {
            fields.tab(name, ImGui::GetIO().KeyShift);
        }
        if (tab || fields.leaving() != FieldFocus::Leave::No) {
            ImGui::ClearActiveID();
            context.animate();
        }
    }
    drawn.holds = ImGui::GetActiveID() == id;
    if (drawn.holds) {
        drawFocus(context);
    }
    const bool again = fields.leaving() == FieldFocus::Leave::Click && refused != nullptr && fields.entry &&
                       fields.entry->text == refused->entry.text;
    drawn.abandoned = drawn.held && !drawn.holds && (again || imgui::keyPressed(key::kEscape, false));
    return drawn;
}

} // namespace

bool inputText(WidgetContext &context, std::string_view name, std::string &value, std::string_view hint, float width,
               bool onEnter, bool focus, bool selectAll) {
    const int enter = onEnter ? ImGuiInputTextFlags_EnterReturnsTrue : ImGuiInputTextFlags_None;
    const int all = selectAll ? ImGuiInputTextFlags_AutoSelectAll : ImGuiInputTextFlags_None;
    const Drawn drawn = drawField(context, name, value, hint, width, enter | all, focus);
    return drawn.returned || (drawn.replaced && !onEnter);
}

bool entry(WidgetContext &context, std::string_view name, std::string &value, std::string_view hint, float width,
           bool selectAll) {
    FieldFocus &fields = context.widgets.fields;
    const std::string before = value;
    if (const FieldFocus::Refused *const refused = fields.refused(name)) {
        if (refused->entry.initial == before) {
            value = refused->entry.text;
        } else {
            fields.forgive(name); // it shows another value
        }
    }
    const Drawn drawn = drawField(context, name, value, hint, width,
                                  selectAll ? ImGuiInputTextFlags_AutoSelectAll : ImGuiInputTextFlags_None, false);
    std::optional<FieldFocus::Entry> &being = fields.entry;
    const bool mine = being && being->name == name;
    if (drawn.replaced) {
        const std::string initial = mine ? being->initial : before;
        if (mine) {
            being.reset();
        }
        fields.forgive(name);
        fields.commit({std::string(name), initial, value, std::string(hint)}, true);
        return value != initial;
    }
    if (drawn.holds) {
        if (!mine) {
            const FieldFocus::Refused *const refused = fields.refused(name);
            being = {std::string(name), refused != nullptr ? refused->entry.initial : before, value, std::string(hint)};
        }
        being->text = std::exchange(value, before);
        return false;
    }
    if (!mine) {
        value = before;
        return false;
    }
    // If another widget took the focus, the field was not drawn as active and shows the text from before.
    FieldFocus::Entry typed = *std::exchange(being, std::nullopt);
    typed.text = drawn.abandoned ? typed.initial : drawn.held ? value : typed.text;
    const bool changed = typed.text != typed.initial;
    fields.forgive(name);
    value = changed ? typed.text : before;
    if (changed) {
        // A widget that is clicked may be drawn later in this frame; a click on the canvas waits for the outcome.
        const bool clicked =
            ImGui::IsMouseClicked(ImGuiMouseButton_Left) && fields.leaving() != FieldFocus::Leave::Click;
        fields.commit(std::move(typed), clicked || ImGui::IsAnyItemActive());
    }
    return changed;
}

bool showsEdited(const WidgetContext &context, std::string_view name, float width) {
    const FieldFocus &fields = context.widgets.fields;
    if ((fields.entry && fields.entry->name == name) || fields.wants(name) || fields.refused(name) != nullptr) {
        return true;
    }
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const float room = width < 0.0F ? ImGui::GetContentRegionAvail().x : context.px(static_cast<double>(width));
    const bool pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Left) || ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    return pressed && ImGui::IsMouseHoveringRect(min, {min.x + room, min.y + ImGui::GetFrameHeight()});
}

void startTabbing(WidgetContext &context) {
    FieldFocus &fields = context.widgets.fields;
    if (tabPressed() && !ImGui::IsAnyItemActive() && fields.held().empty() &&
        ImGui::IsWindowFocused(kWindowWithoutPopups)) {
        fields.tabInto(ImGui::GetCurrentWindowRead()->RootWindow->ID, ImGui::GetIO().KeyShift);
        context.animate();
    }
}

bool takesFocus(WidgetContext &context, std::string_view name) {
    const ImGuiWindow *const window = ImGui::GetCurrentWindowRead();
    if ((window->RootWindow->Flags & ImGuiWindowFlags_Modal) == 0 || window->SkipItems) {
        return false;
    }
    FieldFocus &fields = context.widgets.fields;
    fields.drawn(name, window->RootWindow->ID);
    if (fields.takes(name)) {
        fields.hold(name);
        fields.gotFocus(name);
        context.animate();
    }
    if (fields.held() != name) {
        return false;
    }
    const bool left = ImGui::IsAnyItemActive() || ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    if (!left && tabPressed()) {
        fields.tab(name, ImGui::GetIO().KeyShift);
    }
    if (left || tabPressed()) {
        fields.hold({});
        context.animate();
    }
    return !fields.held().empty();
}

bool enterPressed() {
    const bool pressed = imgui::keyPressed(key::kEnter, false) || imgui::keyPressed(key::kKeypadEnter, false);
    return pressed && ImGui::IsWindowFocused(kWindowWithoutPopups);
}

bool enterOutsideFields() {
    return enterPressed() && !ImGui::IsAnyItemActive();
}

Typing typing() {
    const ImGuiID active = ImGui::GetActiveID();
    const ImGuiInputTextState *state = active != 0 ? ImGui::GetInputTextState(active) : nullptr;
    return state == nullptr ? Typing{} : Typing{true, state->GetUndoAvailCount() > 0, state->GetRedoAvailCount() > 0};
}

} // namespace forefront::ui
