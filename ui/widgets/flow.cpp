#include "ui/widgets/flow.hpp"

#include <imgui.h>

#include <cmath>

namespace forefront::ui {

void Flow::item(const char *name) {
    end();
    begun_ = ImGui::GetID(name);
    if (used_ > 0.0F && used_ + gap_ + ImGui::GetStateStorage()->GetFloat(begun_) <= room_) {
        ImGui::SameLine(0, gap_);
        used_ += gap_;
    } else {
        used_ = 0.0F;
    }
    ImGui::BeginGroup();
}

void Flow::end() {
    if (begun_ == 0) {
        return;
    }
    ImGui::EndGroup();
    const float width = ImGui::GetItemRectSize().x;
    ImGuiStorage &widths = *ImGui::GetStateStorage();
    if (std::abs(width - widths.GetFloat(begun_)) > 0.5F) {
        widths.SetFloat(begun_, width);
        context_.animate(); // the rows may have changed
    }
    used_ += width;
    begun_ = 0;
}

} // namespace forefront::ui
