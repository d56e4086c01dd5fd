#include "ui/widgets/text_wrap.hpp"

#include <imgui.h>

namespace forefront::ui {

std::string wrapped(std::string_view text, float width) {
    const auto extent = [](std::string_view words) {
        return ImGui::CalcTextSize(words.data(), words.data() + words.size()).x;
    };
    std::string result;
    while (true) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        while (extent(line) > width) {
            std::size_t cut = line.find(' ');
            for (std::size_t next = cut; next != std::string_view::npos && extent(line.substr(0, next)) <= width;) {
                cut = next;
                next = line.find(' ', next + 1);
            }
            if (cut == std::string_view::npos) {
                break;
            }
            result.append(line.substr(0, cut)).append("\n");
            line.remove_prefix(cut + 1);
        }
        result.append(line);
        if (end == std::string_view::npos) {
            return result;
        }
        result += '\n';
        text.remove_prefix(end + 1);
    }
}

void wrappedText(std::string_view text, float width) {
    const float room = width > 0.0F ? width : ImGui::GetContentRegionAvail().x;
    const std::string lines = wrapped(text, room);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room + 1.0F);
    ImGui::TextUnformatted(lines.c_str());
    ImGui::PopTextWrapPos();
}

} // namespace forefront::ui
