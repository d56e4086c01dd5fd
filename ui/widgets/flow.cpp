#include "ui/widgets/flow.hpp"

#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <cmath>
#include <utility>

namespace forefront::ui {

namespace {

constexpr const char *kWholeWidth = "##whole", *kBareWidth = "##bare";

} // namespace

Flow::Flow(WidgetContext &context, float room, float gap, const char *overflow)
    : context_(context), room_(room), gap_(gap), overflow_(overflow) {
    if (overflow_ != nullptr) {
        widths_ = ImGui::GetStateStorage();
        // Where items go to the other window in any case, the labels of those that stay say more than further items.
        labels_ = widths_->GetFloat(ImGui::GetID(kWholeWidth)) <= room_ ||
                  widths_->GetFloat(ImGui::GetID(kBareWidth)) > room_;
    }
}

void Flow::label(std::string_view text) {
    const float width = ImGui::CalcTextSize(text.data(), text.data() + text.size()).x + ImGui::GetStyle().ItemSpacing.x;
    labelled_ += width;
    if (!labels_ && !overflows_) {
        leftOut_ += width;
        return;
    }
    ImGui::AlignTextToFramePadding();
    muted(context_, text);
    markCaption(context_, text);
    ImGui::SameLine();
}

void Flow::name(std::string_view text) {
    ImGui::AlignTextToFramePadding();
    muted(context_, text);
    markCaption(context_, text);
    ImGui::SameLine(0, context_.px(4));
}

void Flow::finish() {
    end();
    if (overflow_ == nullptr) {
        return;
    }
    const float whole = whole_ + leftOut_;
    for (const auto &[key, width] : {std::pair(kWholeWidth, whole), std::pair(kBareWidth, whole - labelled_)}) {
        float &before = *widths_->GetFloatRef(ImGui::GetID(key));
        if (std::abs(width - before) > 0.5F) {
            before = width;
            context_.animate();
        }
    }
}

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
    whole_ += width + (whole_ > 0.0F ? gap_ : 0.0F);
    if (overflows_) {
        ImGui::End();
        return;
    }
    used_ += width;
}

} // namespace forefront::ui
