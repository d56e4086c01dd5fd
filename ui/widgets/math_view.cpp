#include "ui/widgets/math_view.hpp"

#include "ui/style/imgui_versions.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <vector>

namespace forefront::ui {

namespace {

ImFont &fontOf(const Fonts &fonts, bool italic, int level) {
    return level == 0 ? (italic ? *fonts.italic : *fonts.body) : (italic ? *fonts.indexItalic : *fonts.index);
}

/// Returns the code of the character at a byte of a text in UTF-8, and goes to the next.
unsigned codeAt(std::string_view text, std::size_t &at) {
    const auto first = static_cast<unsigned char>(text[at++]);
    const unsigned more = first < 0xc0 ? 0 : first < 0xe0 ? 1 : first < 0xf0 ? 2 : 3;
    unsigned code = more == 0 ? first : first & (0x3fU >> more);
    for (unsigned k = 0; k < more && at < text.size(); ++k) {
        code = (code << 6U) | (static_cast<unsigned char>(text[at++]) & 0x3fU);
    }
    return code;
}

/// Measures characters in the fonts of the program, by their ink.
class ScreenFont final : public MathFont {
  public:
    explicit ScreenFont(const Fonts &fonts) : fonts_(fonts) {}

    MathExtent extentOf(std::string_view text, bool italic, int level) const override {
        ImFont &font = fontOf(fonts_, italic, level);
        const float baseline = imgui::baselineOf(font);
        MathExtent extent{0.0, -1e9, -1e9};
        for (std::size_t at = 0; at < text.size();) {
            const imgui::GlyphInk ink = imgui::inkOf(font, codeAt(text, at));
            extent.width += static_cast<double>(ink.advance);
            extent.ascent = std::max(extent.ascent, static_cast<double>(baseline - ink.top));
            extent.descent = std::max(extent.descent, static_cast<double>(ink.bottom - baseline));
        }
        return extent;
    }

    /// A line is 1.2 ems high, see fonts.cpp.
    double em(int level) const override {
        return static_cast<double>(imgui::lineOf(fontOf(fonts_, false, level))) / 1.2;
    }

  private:
    const Fonts &fonts_;
};

} // namespace

MathLayout setMath(const WidgetContext &context, const MathNode &formula, bool display) {
    return layoutMath(formula, ScreenFont(context.fonts), display);
}

void drawMath(const WidgetContext &context, const MathLayout &formula, ImVec2 baseline, Colour colour) {
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const auto placed = [&](Vec2 at) {
        return ImVec2{baseline.x + static_cast<float>(at.x), baseline.y + static_cast<float>(at.y)};
    };
    for (const MathText &text : formula.texts) {
        ImFont &measured = fontOf(context.fonts, text.italic, text.level);
        ImFont &font = text.scale > 1.0 ? *context.fonts.sum : measured;
        const float size = imgui::lineOf(measured) * static_cast<float>(text.scale);
        const ImVec2 at = placed(text.at);
        const float top = at.y - imgui::baselineOf(font) * size / imgui::lineOf(font);
        list.AddText(&font, size, {std::round(at.x), std::round(top)}, colour, text.text.data(),
                     text.text.data() + text.text.size());
    }
    const auto thickness = static_cast<float>(std::max(1.0, std::round(formula.thickness)));
    for (const MathStroke &stroke : formula.strokes) {
        if (stroke.points.size() == 2 && stroke.points[0].y == stroke.points[1].y) { // on whole pixels, to be sharp
            const ImVec2 from = placed(stroke.points[0]), to = placed(stroke.points[1]);
            const float top = std::round(from.y - 0.5F * thickness);
            list.AddRectFilled({from.x, top}, {to.x, top + thickness}, colour);
            continue;
        }
        std::vector<ImVec2> points;
        std::transform(stroke.points.begin(), stroke.points.end(), std::back_inserter(points), placed);
        list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, thickness * 1.1F);
    }
}

} // namespace forefront::ui
