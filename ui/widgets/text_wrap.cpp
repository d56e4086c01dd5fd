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

std::string twoLines(std::string_view text, float width) {
    std::string lines = wrapped(text, width);
    const std::size_t first = lines.find('\n');
    const std::size_t second = first == std::string::npos ? first : lines.find('\n', first + 1);
    if (second == std::string::npos || lines.find_first_not_of('\n', second) == std::string::npos) {
        return lines.substr(0, second);
    }
    lines.resize(second);
    const auto tooWide = [&] {
        return ImGui::CalcTextSize((lines.substr(first + 1) + "\xe2\x80\xa6").c_str()).x > width;
    };
    while (tooWide() && lines.rfind(' ') != std::string::npos && lines.rfind(' ') > first) {
        lines.resize(lines.rfind(' '));
    }
    return lines + "\xe2\x80\xa6";
}

std::string oneLine(std::string_view text, float width) {
    std::string line(text);
    const auto tooWide = [&] { return ImGui::CalcTextSize(line.c_str()).x > width; };
    for (std::size_t cut = text.rfind(' '); tooWide() && cut != std::string_view::npos && cut > 0;
         cut = text.rfind(' ', cut - 1)) {
        line = std::string(text.substr(0, cut)) + "\xe2\x80\xa6";
    }
    return line;
}

void wrappedText(std::string_view text, float width) {
    const float room = width > 0.0F ? width : ImGui::GetContentRegionAvail().x;
    const std::string lines = wrapped(text, room);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room + 1.0F);
    ImGui::TextUnformatted(lines.c_str());
    ImGui::PopTextWrapPos();
}

} // namespace forefront::ui
