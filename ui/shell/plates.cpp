#include "ui/parts/shown_panels.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/start_page.hpp"
#include "ui/widgets/popup_style.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront::shell {

namespace {

/// Returns the action that opens and closes the plate of a panel.
const char *actionOfPlate(const Panel &panel) {
    return panel.place() == PanelPlace::Canvas   ? "view.layers"
           : panel.place() == PanelPlace::Drawer ? "view.log"
                                                 : "edit.history";
}

/// A panel that lies over the canvas, with its heading and a button that closes it.
class PanelPlate {
  public:
    PanelPlate(Shell &context, const char *name, const PixelRect &rect)
        : context_(context), name_(name), style_(context, 12, 8) {
        ImGui::SetNextWindowPos({static_cast<float>(rect.x), static_cast<float>(rect.y)});
        ImGui::SetNextWindowSize({static_cast<float>(rect.width), static_cast<float>(rect.height)});
        ImGui::Begin(("##plate" + name_).c_str(), nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                         ImGuiWindowFlags_NoScrollWithMouse);
    }
    ~PanelPlate() {
        ui::markWindow(context_, "plate/" + name_);
        ImGui::End();
    }
    PanelPlate(const PanelPlate &) = delete;
    PanelPlate &operator=(const PanelPlate &) = delete;

    /// Draws the heading, and the panel below it. Returns true if it is to be closed, and reports the height that the
    /// panel needs.
    bool draw(Panel &panel, float &needed) {
        ui::heading(context_, panel.title());
        ui::mark(context_, std::string("panel/") + panel.id());
        ImGui::SameLine(ImGui::GetContentRegionMax().x - context_.px(22));
        const bool close =
            ui::iconButton(context_, "plate/" + name_ + "/close", icon::kCross, "Close", false, true, 22.0F);
        const float top = ImGui::GetCursorPosY();
        ImGui::BeginChild("content", {0, 0}, false, ImGuiWindowFlags_NoNav);
        panel.draw(context_);
        needed = top + ImGui::GetCursorPosY() + context_.px(4);
        ImGui::EndChild();
        if (ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows) && ImGui::IsMouseClicked(ImGuiMouseButton_Right) &&
            !context_.menu.opens) {
            std::vector<ContextGroup> groups = panel.menu(context_);
            groups.push_back(ContextGroup{actionOf(actionOfPlate(panel))});
            context_.menu.open(std::move(groups));
        }
        return close;
    }

  private:
    Shell &context_;
    std::string name_;
    ui::PopupStyle style_;
};

/// Draws a panel in a plate as high as its content, at most `rect`. Returns true if it is to be closed.
bool drawPlate(Shell &context, const char *id, PixelRect rect) {
    Panel *const panel = findPanel(context, id);
    if (panel == nullptr || rect.width < 1.0 || rect.height < 1.0) {
        return false;
    }
    float &known = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID(id), context.px(120));
    rect.height = std::min(rect.height, static_cast<double>(known));
    float needed = 0.0F;
    bool close = false;
    {
        PanelPlate plate(context, id, rect);
        close = plate.draw(*panel, needed);
    }
    if (std::abs(needed - known) > 0.5F) {
        known = needed;
        context.animate();
    }
    return close;
}

/// Returns true if the left button was pressed on the canvas beside a plate and the buttons that open it.
bool pressedBeside(const Shell &context, const PixelRect &canvas, const char *plate) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    const auto inside = [&](std::string_view name) {
        const WidgetRegistry::Widget *const widget = context.widgets.find(name);
        return widget != nullptr && widget->rect.contains({at.x, at.y});
    };
    return ImGui::IsMouseClicked(ImGuiMouseButton_Left) && canvas.contains({at.x, at.y}) && !inside(plate) &&
           !inside("canvas/tools");
}

/// Returns true if the page of a lesson outlines a switch of the layers.
bool lessonNeedsLayers(const Shell &context) {
    if (!context.lessons.visible || !context.lessons.open) {
        return false;
    }
    const auto &highlights = context.lessons.open->now().highlights;
    return std::any_of(highlights.begin(), highlights.end(),
                       [](const LessonHighlight &highlight) { return highlight.widget.starts_with("layer/"); });
}

/// Draws the buttons over the upper right corner of the canvas.
void drawLayersButton(Shell &context, const PixelRect &canvas) {
    const float margin = context.px(12);
    ImGui::SetNextWindowPos(
        {static_cast<float>(canvas.x + canvas.width) - margin, static_cast<float>(canvas.y) + margin}, ImGuiCond_Always,
        {1.0F, 0.0F});
    const ui::PopupStyle style(context, 4, 3);
    ImGui::Begin("##canvastools", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (ui::iconButton(context, "canvas/fit", icon::kFit, "Zoom to fit (F)", false, true, 24.0F)) {
        context.actions.run("view.fit", context);
    }
    ImGui::SameLine(0, context.px(2));
    if (ui::button(context, "canvas/layers", "Layers", ui::ButtonKind::Quiet)) {
        context.plates.layers = !context.plates.layers;
        context.animate();
    }
    ui::markWindow(context, "canvas/tools");
    ImGui::End();
}

void drawLayers(Shell &context, const PixelRect &canvas) {
    constexpr double kLeastCanvas = 130.0; // design pixels; the column may cover all of it
    if (canvas.width < static_cast<double>(context.px(kLeastCanvas))) {
        context.plates.layers = false;
        return;
    }
    if (!showsStartPage(context)) { // which has the canvas for itself
        drawLayersButton(context, canvas);
    }
    const bool needed = lessonNeedsLayers(context);
    if (!context.plates.layers && !needed) {
        return;
    }
    const double scale = static_cast<double>(context.scale), margin = 12.0 * scale, top = 48.0 * scale;
    const double width = std::min(216.0 * scale, canvas.width - 2.0 * margin);
    const bool close =
        drawPlate(context, "layers",
                  {canvas.x + canvas.width - margin - width, canvas.y + top, width, canvas.height - top - margin});
    if (close || pressedBeside(context, canvas, "plate/layers")) {
        context.plates.layers = false;
        context.animate();
    }
}

void drawLog(Shell &context, const PixelRect &canvas) {
    if (!context.plates.log) {
        return;
    }
    const double scale = static_cast<double>(context.scale), margin = 12.0 * scale;
    const double width = std::min(720.0 * scale, canvas.width - 2.0 * margin);
    const double height = std::min(240.0 * scale, canvas.height - 2.0 * margin);
    if (drawPlate(
            context, "log",
            {canvas.x + canvas.width - margin - width, canvas.y + canvas.height - margin - height, width, height})) {
        context.plates.log = false;
        context.animate();
    }
}

void drawHistory(Shell &context, const Layout &layout) {
    if (!context.plates.history) {
        return;
    }
    const double scale = static_cast<double>(context.scale), margin = 8.0 * scale;
    const double x = layout.tools.width + margin, y = layout.options.y + layout.options.height + margin;
    const bool close = drawPlate(context, "history", {x, y, 280.0 * scale, layout.canvas.height - 2.0 * margin});
    if (close || pressedBeside(context, layout.canvas, "plate/history")) {
        context.plates.history = false;
        context.animate();
    }
}

} // namespace

void drawPlates(Shell &context, const Layout &layout) {
    drawLayers(context, layout.open);
    drawLog(context, layout.open);
    drawHistory(context, layout);
}

} // namespace forefront::shell
