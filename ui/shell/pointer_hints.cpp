#include "ui/shell/pointer_hints.hpp"

#include "ui/canvas/canvas_painter.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <array>

namespace forefront {
namespace {

/// Names in the settings for the uses of the keys in the strips.
constexpr const char *kDrawingKeys = "keys.drawing", *kMeshingKeys = "keys.meshing";

bool isEmpty(const Shell &context) {
    return context.document.current()->shapes.empty();
}

struct ToolHint {
    std::string_view tool;
    const char *start, *begun; ///< what to do first, and with unfinished input
};

constexpr std::array kToolHints{
    ToolHint{"polygon", "click: corner \xc2\xb7 drag: curve", "click the first corner, or Enter: close"},
    ToolHint{"polyline", "click: node \xc2\xb7 drag: curve", "Enter or double-click: finish"},
    ToolHint{"rectangle", "click: corner, or type x, Tab, y, Enter",
             "click the opposite corner, or type width, Tab, height, Enter"},
    ToolHint{"circle", "click: centre, or type x, Tab, y, Enter",
             "click a point on it, or type its radius (D: diameter), Enter"},
    ToolHint{"ellipse", "click: a corner of its box, or type x, Tab, y, Enter",
             "click the opposite corner of its box, or type width, Tab, height, Enter"},
    ToolHint{"regular", "click: centre, or type x, Tab, y, Enter", "click a corner, or type the radius, Enter"},
    ToolHint{"slot", "click: centre of one end, or type x, Tab, y, Enter", "click: other centre, then a side"},
    ToolHint{"arc", "click: one end; or the centre, as chosen above", "click: next point of the arc"},
    ToolHint{"point", "click: a node of the mesh", ""},
    ToolHint{"region", "click a face to make it a region", ""},
    ToolHint{"trim", "click a piece to remove it", ""},
    ToolHint{"source", "click: fine here \xc2\xb7 drag: along a line", ""},
    ToolHint{"gradient", "drag from the fine end to the coarse end", ""},
    ToolHint{"brush", "drag: paint the element size; Ctrl+click: pick one", ""},
    ToolHint{"eraser", "drag: erase painted sizes", ""},
};

} // namespace

std::string pointerHint(const Settings &settings, std::string_view tool, bool begun) {
    const auto used = settings.toolUses.find(std::string(tool));
    if (used != settings.toolUses.end() && used->second >= kHintedUses) {
        return {};
    }
    const auto found =
        std::find_if(kToolHints.begin(), kToolHints.end(), [tool](const ToolHint &hint) { return hint.tool == tool; });
    return found == kToolHints.end() ? "" : begun ? found->begun : found->start;
}

bool knowsKeys(const Shell &context) {
    const auto used = context.settings.toolUses.find(isEmpty(context) ? kDrawingKeys : kMeshingKeys);
    return used != context.settings.toolUses.end() && used->second >= kHintedUses;
}

void countKeyUse(Shell &context, int code) {
    constexpr std::array<int, 3> kDrawing{'R', 'P', 'C'};
    constexpr std::array<int, 4> kMeshing{'2', key::kSpace, key::kPeriod, 'B'};
    const auto counts = [code](const auto &keys) { return std::find(keys.begin(), keys.end(), code) != keys.end(); };
    if (!knowsKeys(context) && (isEmpty(context) ? counts(kDrawing) : counts(kMeshing))) {
        ++context.settings.toolUses[isEmpty(context) ? kDrawingKeys : kMeshingKeys];
    }
}

void retireKeys(Shell &context) {
    context.settings.toolUses[kMeshingKeys] = kHintedUses;
}

void renewKeys(Shell &context) {
    context.settings.toolUses.erase(kDrawingKeys);
    context.settings.toolUses.erase(kMeshingKeys);
}

void drawPointerHint(CanvasPainter &painter, Shell &context) {
    if (!context.settings.hints || !context.view.pointer || context.dialogs.any() || context.menuKeys.open) {
        return;
    }
    const Tool &tool = context.tools.current();
    const std::string hint = pointerHint(context.settings, tool.id(), !tool.undoLabel(context).empty());
    if (hint.empty()) {
        return;
    }
    constexpr Pixel kBeside{16.0, -30.0}; // numbers are below the pointer
    const Vec2 at = *context.view.pointer;
    painter.label(at, kBeside, hint, context.theme.muted, fade(context.theme.popup, 0.9), context.fonts.small);
    const Pixel corner = context.view.camera.toPixel(at);
    ui::markRect(context, "canvas/hint", {corner.x, corner.y, 1.0, 1.0});
}

ToolUse::ToolUse(const Shell &context) {
    const std::string tool = context.tools.current().id();
    if (!pointerHint(context.settings, tool, false).empty()) {
        tool_ = tool;
        step_ = context.document.step();
    }
}

void ToolUse::finish(Shell &context) const {
    if (!tool_.empty() && context.document.step() != step_) {
        ++context.settings.toolUses[tool_];
    }
}

} // namespace forefront
