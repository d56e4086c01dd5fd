#include "ui/panels/slider_drag.hpp"

#include "ui/parts/shell.hpp"
#include "ui/style/imgui_versions.hpp"

#include <imgui.h>

namespace forefront {

bool SliderDrag::begin(Shell &context) {
    const bool released = !ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (dragged_ && !released && imgui::keyPressed(key::kEscape, false)) {
        context.document.abandonStroke(stroke_);
        cancelled_ = true;
    }
    return released;
}

void SliderDrag::end(Shell &context, bool released) {
    if (!released) {
        return;
    }
    if (dragged_) {
        context.document.endStroke();
    }
    dragged_ = cancelled_ = false;
}

} // namespace forefront
