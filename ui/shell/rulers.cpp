#include "ui/canvas/line_density.hpp"
#include "ui/canvas/ruler_scale.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/style/imgui_versions.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace forefront::shell {
namespace {

// Lengths in design pixels.
constexpr double kMinLabelStep = 48.0, kLabelGap = 10.0, kMinMarkStep = 5.0;
constexpr float kMark = 5.0F, kHalfMark = 9.0F; ///< short marks
constexpr float kLabelShift = 3.0F;             ///< of a label from its mark

/// One of the two rulers. Positions along it are pixels from the left, or from the top.
class Ruler {
  public:
    Ruler(Shell &context, const PixelRect &rect, bool upright)
        : context_(context), rect_(rect), upright_(upright), list_(*ImGui::GetWindowDrawList()) {}

    void draw() {
        const Camera &camera = context_.view.camera;
        const Box2 visible = camera.visible();
        const double low = upright_ ? visible.min.y : visible.min.x, high = upright_ ? visible.max.y : visible.max.x;
        const RulerScale scale = scaleFor(low, high);
        const Multiples marks = multiplesWithin(low, high, scale.minor());
        width_ = static_cast<float>(densityWidth(camera.zoom * scale.minor(), static_cast<double>(context_.px(1))));
        for (int k = 0; k < marks.count; ++k) {
            const double step = marks.first + k;
            if (std::fmod(step, scale.divisions) == 0.0) {
                drawLabel(step / scale.divisions * scale.major, scale.major);
            } else {
                const bool half = std::fmod(2.0 * step, scale.divisions) == 0.0;
                drawMark(along(step * scale.minor()), context_.px(half ? kHalfMark : kMark), context_.theme.faint);
            }
        }
        if (context_.view.pointer) {
            drawPointer(along(upright_ ? context_.view.pointer->y : context_.view.pointer->x));
        }
    }

  private:
    /// Returns the scale for an interval, with enough room for its longest label.
    RulerScale scaleFor(double low, double high) const {
        const double design = static_cast<double>(context_.scale), unit = context_.view.camera.length(design);
        RulerScale scale = rulerScale(unit, kMinLabelStep, kMinMarkStep);
        const auto width = [&](double value) {
            const std::string text = rulerText(std::round(value / scale.major) * scale.major, scale.major);
            return static_cast<double>(ImGui::CalcTextSize(text.c_str()).x) / design;
        };
        const double widest = std::max(width(low), width(high)) + kLabelGap;
        return widest > kMinLabelStep ? rulerScale(unit, widest, kMinMarkStep) : scale;
    }

    float along(double value) const {
        const Camera &camera = context_.view.camera;
        const Pixel at = camera.toPixel(upright_ ? Vec2{camera.centre.x, value} : Vec2{value, camera.centre.y});
        return std::floor(static_cast<float>(upright_ ? at.y : at.x)) + 0.5F;
    }

    /// Draws a mark from the edge beside the canvas inwards.
    void drawMark(float at, float length, Colour colour) {
        const auto right = static_cast<float>(rect_.x + rect_.width),
                   bottom = static_cast<float>(rect_.y + rect_.height);
        if (upright_) {
            list_.AddLine({right - length, at}, {right, at}, colour, width_);
        } else {
            list_.AddLine({at, bottom - length}, {at, bottom}, colour, width_);
        }
    }

    void drawLabel(double value, double major) {
        const float at = along(value), shift = context_.px(kLabelShift);
        const float thickness = static_cast<float>(upright_ ? rect_.width : rect_.height);
        drawMark(at, thickness, context_.theme.line);
        const std::string text = rulerText(value, major);
        if (!upright_) {
            list_.AddText({at + shift, static_cast<float>(rect_.y)}, context_.theme.muted, text.c_str());
            return;
        }
        // Dear ImGui has no turned text: a quarter turn of its corners about the origin makes it read upwards.
        const ImVec2 origin{std::floor(static_cast<float>(rect_.x)), std::floor(at - shift)};
        if (origin.y - ImGui::CalcTextSize(text.c_str()).x < static_cast<float>(rect_.y)) {
            return; // it would lie on the unit in the corner
        }
        const int before = list_.VtxBuffer.Size;
        list_.PushClipRectFullScreen(); // the text is clipped before it is turned
        list_.AddText(origin, context_.theme.muted, text.c_str());
        list_.PopClipRect();
        for (int k = before; k < list_.VtxBuffer.Size; ++k) {
            ImVec2 &corner = list_.VtxBuffer[k].pos;
            corner = {origin.x + (corner.y - origin.y), origin.y - (corner.x - origin.x)};
        }
    }

    void drawPointer(float at) {
        const float size = context_.px(5);
        const auto right = static_cast<float>(rect_.x + rect_.width),
                   bottom = static_cast<float>(rect_.y + rect_.height);
        const Colour colour = context_.theme.accent;
        if (upright_) {
            list_.AddTriangleFilled({right - size, at - size}, {right - size, at + size}, {right, at}, colour);
        } else {
            list_.AddTriangleFilled({at - size, bottom - size}, {at + size, bottom - size}, {at, bottom}, colour);
        }
    }

    Shell &context_;
    PixelRect rect_;
    bool upright_;
    float width_ = 1.0F; ///< of the marks
    ImDrawList &list_;
};

/// Opens the menu of a ruler at the coordinate under the pointer.
void openRulerMenu(Shell &context, bool upright) {
    const Vec2 place = context.view.camera.toPlane({ImGui::GetMousePos().x, ImGui::GetMousePos().y});
    const std::string value = ui::number(upright ? place.y : place.x, 6);
    const Snapping &snapping = context.snapping;
    context.menu.open(
        {{copyCommand("copyCoordinate", std::string("Copy ") + (upright ? "y = " : "x = ") + value, value)},
         {switchOf("snapGrid", "Snap to grid", snapping.toGrid,
                   [](Shell &c) { c.snapping.toGrid = !c.snapping.toGrid; }),
          switchOf("snapDrawing", "Snap to drawing", snapping.toDrawing,
                   [](Shell &c) { c.snapping.toDrawing = !c.snapping.toDrawing; }),
          switchOf("snapGuides", "Snap to guides", snapping.toGuides,
                   [](Shell &c) { c.snapping.toGuides = !c.snapping.toGuides; })},
         actionsOf({"view.fit", "view.zoomSelection", "view.rulers"})});
}

Pixel pointerPixel() {
    return {ImGui::GetMousePos().x, ImGui::GetMousePos().y};
}

void drawRuler(Shell &context, const char *name, const PixelRect &rect, bool upright) {
    beginRegion(name, rect, context.theme.panel, 0, 0);
    ImGui::PushFont(context.fonts.small);
    Ruler(context, rect, upright).draw();
    ImGui::PopFont();
    const auto right = static_cast<float>(rect.x + rect.width), bottom = static_cast<float>(rect.y + rect.height);
    const float inset = 0.5F * context.px(1);
    const ImVec2 corner{right - inset, bottom - inset};
    ImGui::GetWindowDrawList()->AddLine(upright ? ImVec2{corner.x, static_cast<float>(rect.y)}
                                                : ImVec2{static_cast<float>(rect.x), corner.y},
                                        corner, context.theme.line, context.px(1));
    ui::markRect(context, upright ? "canvas/ruler/y" : "canvas/ruler/x", rect);
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        openRulerMenu(context, upright);
    }
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        context.rulerDrag.beginNew(context, upright, pointerPixel());
    }
    ImGui::End();
}

/// Follows the guide that is dragged out of a ruler.
void followRulerDrag(Shell &context) {
    if (!context.rulerDrag.active()) {
        return;
    }
    if (imgui::keyPressed(key::kEscape, false)) {
        context.rulerDrag.cancel(context);
        return;
    }
    context.rulerDrag.update(context, pointerPixel(), ImGui::GetIO().KeyCtrl);
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        context.rulerDrag.finish(context, pointerPixel());
    }
    context.animate();
}

/// Writes the unit of the document where the rulers meet; a click there changes it.
void drawUnit(Shell &context, const PixelRect &corner) {
    const LengthUnit unit = context.document.current()->unit;
    ImGui::SetCursorScreenPos({static_cast<float>(corner.x), static_cast<float>(corner.y)});
    const bool pressed = ui::hitArea("unit", static_cast<float>(corner.width), static_cast<float>(corner.height));
    ui::tooltip(context, unit == LengthUnit::None ? std::string("The drawing has no unit")
                                                  : "Coordinates are in " + std::string(pluralOf(unit)));
    ui::markRect(context, "canvas/ruler/unit", corner);
    if (unit != LengthUnit::None) {
        const std::string word(wordOf(unit));
        const ImFont &font = *context.fonts.small;
        const ImVec2 size = font.CalcTextSizeA(font.FontSize, 1e9F, 0.0F, word.c_str());
        ImGui::GetWindowDrawList()->AddText(
            &font, font.FontSize,
            {std::round(static_cast<float>(corner.x + 0.5 * corner.width) - 0.5F * size.x),
             std::round(static_cast<float>(corner.y + 0.5 * corner.height) - 0.5F * size.y)},
            context.theme.muted, word.c_str());
    }
    if (pressed) {
        context.actions.run("edit.unit", context);
    }
}

} // namespace

void drawRulers(Shell &context, const Layout &layout) {
    followRulerDrag(context); // which may have hidden the rulers
    if (!context.settings.rulers) {
        return;
    }
    drawRuler(context, "##rulerX", layout.rulerX, false);
    drawRuler(context, "##rulerY", layout.rulerY, true);
    beginRegion("##rulerCorner", {layout.rulerY.x, layout.rulerX.y, layout.rulerY.width, layout.rulerX.height},
                context.theme.panel, 0, 0);
    drawUnit(context, {layout.rulerY.x, layout.rulerX.y, layout.rulerY.width, layout.rulerX.height});
    ImGui::End();
}

} // namespace forefront::shell
