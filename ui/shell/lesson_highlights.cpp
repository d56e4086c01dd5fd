#include "ui/parts/shell.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace forefront::shell {

namespace {

/// An outline on the screen, and the part of it that may be drawn.
struct HighlightBox {
    PixelRect rect, clip;
};

PixelRect grownBy(const PixelRect &r, double margin) {
    return {r.x - margin, r.y - margin, r.width + 2.0 * margin, r.height + 2.0 * margin};
}

PixelRect around(const PixelRect &a, const PixelRect &b) {
    const double x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

/// Returns true if two rectangles are neighbours in a column or in a row, so that one outline fits around both.
bool inLine(const PixelRect &a, const PixelRect &b) {
    const auto near = [](double p, double q) { return std::abs(p - q) < 2.0; };
    return (near(a.x, b.x) && near(a.width, b.width)) || (near(a.y, b.y) && near(a.height, b.height));
}

/// Adds a box, or widens one that its line, `line` pixels wide, would touch.
void addBox(std::vector<HighlightBox> &boxes, HighlightBox box, double line) {
    const auto meets = [&](const HighlightBox &other) {
        return grownBy(other.rect, line).overlaps(box.rect) && inLine(other.rect, box.rect) && other.clip == box.clip;
    };
    for (auto other = boxes.begin(); (other = std::find_if(boxes.begin(), boxes.end(), meets)) != boxes.end();) {
        box.rect = around(box.rect, other->rect);
        boxes.erase(other); // the wider box may meet others
    }
    boxes.push_back(box);
}

} // namespace

void drawHighlights(Shell &context) {
    if (context.dialogs.any()) {
        return;
    }
    const double gap = static_cast<double>(context.px(4)), line = static_cast<double>(context.px(2));
    std::vector<HighlightBox> boxes;
    for (const LessonHighlight &highlight : context.lessons.open->now().highlights) {
        const WidgetRegistry::Widget *const widget = context.widgets.find(highlight.widget);
        if (widget != nullptr && widget->visible) {
            addBox(boxes, {grownBy(widget->rect, gap), grownBy(widget->clip.value_or(widget->rect), gap + line)}, line);
        }
    }
    ImDrawList &list = *ImGui::GetForegroundDrawList();
    const auto corner = [](double x, double y) { return ImVec2{static_cast<float>(x), static_cast<float>(y)}; };
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        const auto &[r, clip] = boxes[k];
        list.PushClipRect(corner(clip.x, clip.y), corner(clip.x + clip.width, clip.y + clip.height));
        list.AddRect(corner(r.x, r.y), corner(r.x + r.width, r.y + r.height), context.theme.warn, context.px(5), 0,
                     context.px(2));
        list.PopClipRect();
        context.widgets.add("lesson/highlight/" + std::to_string(k), {r, true, true, clip});
    }
}

} // namespace forefront::shell
