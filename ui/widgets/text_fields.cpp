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

/// Makes Ctrl+Shift+Z redo in text fields: Dear ImGui 1.86 knows only Ctrl+Y, so Z is shown to it as Y while the keys
/// are held.
class RedoByShiftZ {
  public:
    RedoByShiftZ()
        : io_(ImGui::GetIO()), swapped_(io_.KeyCtrl && io_.KeyShift && io_.KeysDown[io_.KeyMap[ImGuiKey_Z]]) {
        if (swapped_) {
            swap();
            io_.KeyShift = false;
            io_.KeyMods &= ~ImGuiKeyModFlags_Shift;
        }
    }
    ~RedoByShiftZ() {
        if (swapped_) {
            swap();
            io_.KeyShift = true;
            io_.KeyMods |= ImGuiKeyModFlags_Shift;
        }
    }
    RedoByShiftZ(const RedoByShiftZ &) = delete;
    RedoByShiftZ &operator=(const RedoByShiftZ &) = delete;

  private:
    void swap() { std::swap(io_.KeyMap[ImGuiKey_Z], io_.KeyMap[ImGuiKey_Y]); }

    ImGuiIO &io_;
    bool swapped_;
};

/// Notes that the field just drawn was clicked with the right button, and which part of its text is selected.
void noteRightClick(FieldFocus &fields, std::string_view name, const std::string &text, ImGuiID id) {
    if (!ImGui::IsItemHovered() || !ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        return;
    }
    std::size_t begin = 0, end = text.size();
    const ImGuiInputTextState *const state = ImGui::GetActiveID() == id ? ImGui::GetInputTextState(id) : nullptr;
    if (state != nullptr && state->HasSelection()) {
        const auto [low, high] = std::minmax(state->Stb.select_start, state->Stb.select_end);
        const ImWchar *const letters = state->TextW.Data; // the selection counts letters, the text has bytes
        begin = std::min(end, static_cast<std::size_t>(ImTextCountUtf8BytesFromStr(letters, letters + low)));
        end = std::min(end, static_cast<std::size_t>(ImTextCountUtf8BytesFromStr(letters, letters + high)));
    }
    fields.clicked = {std::string(name), text, {}, begin, end};
}

struct Drawn {
    bool returned = false; ///< returned by Dear ImGui
    bool replaced = false; ///< a command of the menu of the field has given it another text
    bool held = false;     ///< the field had the focus in the last frame, so its text was typed
    bool holds = false;    ///< the field has the focus now
};

bool tabPressed() {
    return ImGui::IsKeyPressed(key::kTab) && !ImGui::GetIO().KeyCtrl && !ImGui::GetIO().KeyAlt;
}

/// Draws a text field and adds it to the order in which Tab visits fields.
Drawn drawField(WidgetContext &context, std::string_view name, std::string &value, std::string_view hint, float width,
                ImGuiInputTextFlags flags, bool focus) {
    FieldFocus &fields = context.widgets.fields;
    ImGui::PushID(name.data(), name.data() + name.size());
    const ImGuiID id = ImGui::GetID("##text");
    ImGui::SetNextItemWidth(width < 0.0F ? -1.0F : context.px(static_cast<double>(width)));
    if (focus || fields.takes(name)) {
        ImGui::SetKeyboardFocusHere();
        context.animate();
    }
    Drawn drawn{.held = ImGui::GetActiveID() == id};
    {
        const RedoByShiftZ redo;
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
        if (tab || fields.leaving()) {
            ImGui::ClearActiveID();
            context.animate();
        }
    }
    // Forget the undo history of a field that was left: its changes now belong to the history of the document.
    if (ImGuiInputTextState *state = ImGui::GetInputTextState(id); state != nullptr && ImGui::GetActiveID() != id) {
        state->ID = 0;
    }
    drawn.holds = ImGui::GetActiveID() == id;
    if (drawn.holds) {
        drawFocus(context);
    }
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
    const std::string before = value;
    const Drawn drawn = drawField(context, name, value, hint, width,
                                  selectAll ? ImGuiInputTextFlags_AutoSelectAll : ImGuiInputTextFlags_None, false);
    std::optional<FieldFocus::Entry> &being = context.widgets.fields.entry;
    const bool mine = being && being->name == name;
    if (drawn.replaced) {
        const bool changed = value != (mine ? being->initial : before);
        if (mine) {
            being.reset();
        }
        return changed;
    }
    if (drawn.holds) {
        if (!mine) {
            being = {std::string(name), before, value};
        }
        being->text = std::exchange(value, before);
        return false;
    }
    if (!mine) {
        value = before;
        return false;
    }
    // If another widget took the focus, the field was not drawn as active and shows the text from before.
    value = drawn.held ? value : being->text;
    const bool changed = value != being->initial;
    being.reset();
    value = changed ? value : before;
    if (changed) {
        context.widgets.fields.committed = name;
    }
    return changed;
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
    const bool pressed = ImGui::IsKeyPressed(key::kEnter, false) || ImGui::IsKeyPressed(key::kKeypadEnter, false);
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
