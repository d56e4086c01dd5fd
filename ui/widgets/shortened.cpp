#include "ui/widgets/shortened.hpp"

#include "ui/style/imgui_versions.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cstddef>

namespace forefront::ui {

void shortened(const WidgetContext &context, Pixel at, float right, std::string_view text, Colour colour) {
    const char *const begin = text.data(), *const end = text.data() + text.size();
    const ImVec2 size = ImGui::CalcTextSize(begin, end);
    const ImVec2 corner{static_cast<float>(at.x), static_cast<float>(at.y)};
    if (right - corner.x < context.px(12)) {
        return; // not even an ellipsis
    }
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    imgui::textUpTo(corner, right, begin, end, size);
    ImGui::PopStyleColor();
}

std::string withoutMiddle(const std::string &text, float width) {
    const auto widthOf = [](const std::string &part) { return ImGui::CalcTextSize(part.c_str()).x; };
    if (widthOf(text) <= width) {
        return text;
    }
    const auto starts = [&text](std::size_t at) { // a character of UTF-8
        return at == text.size() || (static_cast<unsigned char>(text[at]) & 0xc0U) != 0x80U;
    };
    std::size_t head = text.size() / 2, tail = head;
    std::string shown;
    do {
        if (head <= text.size() - tail) { // the shorter part stays
            ++tail;
            while (tail < text.size() && !starts(tail)) {
                ++tail;
            }
        } else {
            --head;
            while (head > 0 && !starts(head)) {
                --head;
            }
        }
        while (head > 0 && !starts(head)) {
            --head;
        }
        shown = text.substr(0, head) + "\xe2\x80\xa6" + text.substr(std::min(tail, text.size()));
    } while ((head > 0 || tail < text.size()) && widthOf(shown) > width);
    return shown;
}

} // namespace forefront::ui
