#include "ui/editor/cursor.hpp"

#include "ui/parts/shell.hpp"

#include <imgui.h>

namespace forefront {

namespace {

CursorShape cursorOf(ImGuiMouseCursor cursor) {
    switch (cursor) {
    case ImGuiMouseCursor_TextInput:
        return CursorShape::Text;
    case ImGuiMouseCursor_ResizeEW:
        return CursorShape::ResizeHorizontal;
    case ImGuiMouseCursor_ResizeNS:
        return CursorShape::ResizeVertical;
    case ImGuiMouseCursor_Hand:
        return CursorShape::Hand;
    default:
        return CursorShape::Arrow;
    }
}

} // namespace

void applyCursor(Shell &context, bool panning) {
    const bool onCanvas = context.view.pointer.has_value() && !ImGui::GetIO().WantCaptureMouse;
    if (panning) {
        context.platform.setCursor(CursorShape::Move);
    } else if (onCanvas) {
        context.platform.setCursor(context.tools.current().cursor());
    } else {
        context.platform.setCursor(cursorOf(ImGui::GetMouseCursor()));
    }
}

} // namespace forefront
