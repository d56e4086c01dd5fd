#include "ui/canvas/legend.hpp"
#include "ui/parts/preview_dialog.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/run_plot.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace forefront::shell {

namespace {

constexpr double kMenuHeight = 40, kOptionsHeight = 36, kTimelineHeight = 78, kStatusHeight = 26;
constexpr double kTabsHeight = 32;
constexpr double kLessonWidth = 330;
constexpr double kNarrow = 800;          ///< width of a window that has no room for the column beside the canvas
constexpr double kLessonAlone = kNarrow; ///< width of a window that has room for a lesson or the column, not both
constexpr double kFiguresHeight = 66, kFiguresRow = 20; ///< heights of the comparison table and of a row in it
constexpr double kRuler = 20;
constexpr double kMinColumn = 250; ///< fields of a narrower column are unreadable

/// Returns the height of the panel below the canvas, with whole rows; design pixels. `window`: height of the window,
/// `middle`: of the canvas and the panel.
double belowHeight(const Shell &context, double window, double middle) {
    if (context.settings.workspace != WorkspaceKind::Judge || context.sides.views() > 0) {
        return 0.0;
    }
    constexpr double kHeading = 32.0, kHint = 28.0, kShare = 0.25, kLowest = 116.0, kHighest = 320.0;
    if (isFolded(context, "worst")) {
        return kHeading;
    }
    if (context.judgement->worst.empty()) {
        return kHeading + kHint;
    }
    constexpr double kRow = 24.0, kFoot = 4.0, kTitles = kHeading + kRow + kFoot, kMostOfMiddle = 0.4;
    const double room = std::min(std::clamp(kShare * window, kLowest, kHighest), kMostOfMiddle * middle);
    return kTitles + kRow * std::max(1.0, std::floor((room - kTitles) / kRow));
}

/// Returns the width of the column for a window of this width; design pixels.
double columnWidth(const Settings &settings, double window) {
    constexpr double kShare = 0.211, kLeast = 304.0, kMost = 360.0;
    return settings.panelWidth.value_or(std::round(std::clamp(kShare * window, kLeast, kMost)));
}

/// Returns the width of a dialog in the place of the column, which previews its result on the canvas, in pixels; 0 if
/// there is none.
double previewWidth(const Shell &context) {
    const auto *const preview = dynamic_cast<const PreviewDialog *>(context.dialogs.top());
    if (preview == nullptr || preview->inOptionsBar()) {
        return 0.0;
    }
    const WidgetRegistry::Widget *const dialog = context.widgets.find(std::string("dialog/") + preview->id());
    return dialog != nullptr ? dialog->rect.width : 0.0;
}

} // namespace

bool columnFloats(const Shell &context) {
    return context.platform.framebufferSize().width < static_cast<double>(context.px(kNarrow));
}

bool lessonAlone(const Shell &context) {
    return context.lessons.visible &&
           context.platform.framebufferSize().width < static_cast<double>(context.px(kLessonAlone));
}

bool columnShown(const Shell &context) {
    return columnFloats(context) ? context.plates.column && !lessonAlone(context) : context.view.panels;
}

Layout layOut(const Shell &context) {
    const PixelSize size = context.platform.framebufferSize();
    const double width = size.width, height = size.height;
    const auto px = [&](double design) { return std::round(static_cast<double>(context.px(design))); };
    const bool presents = context.presentedFrom.has_value(); // then only the canvas, the timeline and a column
    Layout layout;
    layout.menu = {0, 0, width, presents ? 0.0 : px(kMenuHeight)};
    const double status = presents ? 0.0 : px(kStatusHeight);
    const bool steps = context.settings.workspace == WorkspaceKind::Step;
    const double timeline = steps ? px(kTimelineHeight + (context.view.runPlot ? kPlotHeight : 0.0)) : 0.0;
    layout.status = {0, height - status, width, status};
    layout.timeline = {0, height - status - timeline, width, timeline};
    layout.tabs = {0, layout.menu.height, width, presents || context.tabs.size() < 2 ? 0.0 : px(kTabsHeight)};
    layout.options = {0, layout.menu.height + layout.tabs.height, width, presents ? 0.0 : px(kOptionsHeight)};
    const double top = layout.options.y + layout.options.height;
    const double middle = std::max(0.0, layout.timeline.y - top);
    const double tools = presents ? 0.0 : px(stripOf(context, middle).width());
    // In a narrow window the canvas keeps more than half of the remaining width.
    const double widest = std::max(px(kMinColumn), 0.45 * (width - tools));
    const double wanted = px(columnWidth(context.settings, width / static_cast<double>(context.scale)));
    const bool floats = columnFloats(context) && !presents;
    const double shown = floats ? std::min(wanted, 0.9 * (width - tools))
                                : std::min({wanted, widest, std::max(0.0, 0.6 * (width - tools))});
    const double beside = presents || columnShown(context) ? shown : 0.0; // the column covers what is behind it
    const double column = floats ? 0.0 : beside;
    layout.tools = {0, top, tools, middle};
    const double lessons =
        context.lessons.visible ? std::min(px(kLessonWidth), std::max(0.0, 0.5 * (width - tools - column))) : 0.0;
    layout.lessons = {tools, top, lessons, middle};
    const double room = std::max(1.0, width - tools - lessons - column);
    const auto views = static_cast<double>(context.sides.views());
    const auto compared = static_cast<double>(context.sides.visible ? context.sides.size() : 0);
    const double canvas = std::max(1.0, std::floor(room / (views + 1.0)));
    const double figures =
        compared > 0.0 ? std::min(px(kFiguresHeight + kFiguresRow * (compared + 1.0)), std::floor(0.4 * middle)) : 0.0;
    const double design = static_cast<double>(context.scale);
    const double under = std::min(px(belowHeight(context, height / design, middle / design)), std::floor(0.4 * middle));
    // A column over the canvas leaves the panel below in sight.
    layout.column = {width - beside, top, beside, floats ? middle - under : middle};
    const double canvasHeight = std::max(1.0, middle - figures - under);
    const double ruler = context.settings.rulers ? px(kRuler) : 0.0, left = tools + lessons;
    layout.canvas = {left + ruler, top + ruler, std::max(1.0, canvas - ruler), std::max(1.0, canvasHeight - ruler)};
    const double covered = std::max(floats ? beside : 0.0, previewWidth(context));
    layout.open = layout.canvas;
    layout.open.width = std::max(1.0, std::min(layout.canvas.width, width - covered - layout.canvas.x));
    layout.rulerX = {left + ruler, top, layout.canvas.width, ruler};
    layout.rulerY = {left, top + ruler, ruler, layout.canvas.height};
    layout.sides = {tools + lessons + canvas, top, room - canvas, canvasHeight};
    layout.below = {tools + lessons, top + canvasHeight, room, under};
    layout.figures = {tools + lessons, top + canvasHeight, room, figures};
    return layout;
}

CanvasBands bandsOf(const Shell &context, const PixelRect &canvas) {
    const auto legends =
        static_cast<int>(std::count_if(context.layers.begin(), context.layers.end(),
                                       [](const LayerSlot &slot) { return slot.visible && slot.layer->hasLegend(); }));
    const int abreast = legendsAbreast(canvas.width / static_cast<double>(context.scale));
    const int rows = std::max(1, (legends + abreast - 1) / abreast); // reserve a row even if no legend is shown
    const int lowest = std::min(legends, abreast);
    return {.top = 56.0,
            .legends = kLegendMargin + lowest * (kLegendWidth + kLegendGap),
            .bottom = kLegendMargin + rows * (kLegendHeight + kLegendGap)};
}

namespace {

/// Returns the height of a drawing of usual proportions that fits into a room.
double fittedHeight(const PixelRect &room) {
    constexpr double kProportion = 1.5;
    return std::min(room.height, room.width / kProportion);
}

} // namespace

PixelRect freeRoom(const Shell &context, const PixelRect &canvas) {
    const CanvasBands bands = bandsOf(context, canvas);
    const double scale = static_cast<double>(context.scale);
    // On a small canvas the drawing keeps a third of the height, even if plates cover part of it.
    const double top = std::min(bands.top * scale, 0.2 * canvas.height);
    const double bottom = std::min(bands.bottom * scale, 0.45 * canvas.height);
    const PixelRect between{canvas.x, canvas.y + top, canvas.width, canvas.height - top - bottom};
    // All plates are at the right: a low canvas has more room beside them.
    constexpr double kLow = 420.0, kLayers = 120.0; // design pixels; the button for the layers with its margin
    const double margin = kLegendMargin * scale;
    const double right = std::max(bands.legends, kLayers) * scale;
    const PixelRect beside{canvas.x, canvas.y + margin, canvas.width - right, canvas.height - 2.0 * margin};
    const bool low = canvas.height < kLow * scale;
    return low && fittedHeight(beside) > fittedHeight(between) ? beside : between;
}

void beginRegion(const char *name, const PixelRect &rect, Colour background, float padX, float padY) {
    ImGui::SetNextWindowPos({static_cast<float>(rect.x), static_cast<float>(rect.y)});
    ImGui::SetNextWindowSize({static_cast<float>(rect.width), static_cast<float>(rect.height)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(padX, padY));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, background);
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

} // namespace forefront::shell
