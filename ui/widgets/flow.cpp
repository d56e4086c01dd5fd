#include "ui/widgets/flow.hpp"

#include <imgui.h>

#include <cmath>

namespace forefront::ui {

void Flow::item(const char *name) {
    end();
    begun_ = ImGui::GetID(name);
    if (overflow_ != nullptr) {
        beginInRow();
        return;
    }
    if (used_ > 0.0F && used_ + gap_ + ImGui::GetStateStorage()->GetFloat(begun_) <= room_) {
        ImGui::SameLine(0, gap_);
        used_ += gap_;
    } else {
        used_ = 0.0F;
    }
    ImGui::BeginGroup();
}

/// Begins an item in the single row, or in the window beside it once an item has not fitted.
void Flow::beginInRow() {
    const float gap = used_ > 0.0F ? gap_ : 0.0F;
    overflows_ = overflows_ || used_ + gap + ImGui::GetStateStorage()->GetFloat(begun_) > room_;
    widths_ = ImGui::GetStateStorage();
    if (overflows_) {
        ImGui::Begin(overflow_);
    } else if (used_ > 0.0F) {
        ImGui::SameLine(0, gap_);
        used_ += gap_;
    }
    ImGui::BeginGroup();
}

void Flow::end() {
    if (begun_ == 0) {
        return;
    }
    ImGui::EndGroup();
    const float width = ImGui::GetItemRectSize().x;
    ImGuiStorage &widths = widths_ != nullptr ? *widths_ : *ImGui::GetStateStorage();
    if (std::abs(width - widths.GetFloat(begun_)) > 0.5F) {
        widths.SetFloat(begun_, width);
        context_.animate(); // the rows may have changed
    }
    begun_ = 0;
    if (overflows_) {
        ImGui::End();
        return;
    }
    used_ += width;
}

} // namespace forefront::ui
