#include "ui/flow.hpp"

#include <imgui.h>

#include <cmath>

namespace forefront::ui {

void Flow::item(const char *name) {
    end();
    width_ = ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID(name), 0.0F);
    if (used_ > 0.0F && used_ + gap_ + *width_ <= room_) {
        ImGui::SameLine(0, gap_);
        used_ += gap_;
    } else {
        used_ = 0.0F;
    }
    ImGui::BeginGroup();
}

void Flow::end() {
    if (width_ == nullptr) {
        return;
    }
    ImGui::EndGroup();
    const float width = ImGui::GetItemRectSize().x;
    if (std::abs(width - *width_) > 0.5F) {
        *width_ = width;
        context_.animate(); // the rows may be others now
    }
    used_ += width;
    width_ = nullptr;
}

} // namespace forefront::ui
