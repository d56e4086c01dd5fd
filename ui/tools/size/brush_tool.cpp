#include "ui/tools/size/brush_tool.hpp"

#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/hash.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/parts/paint/paint.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/common/tool_options.hpp"
#include "ui/widgets/enum_choice.hpp"
#include "ui/widgets/flow.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace forefront {
namespace {

constexpr double kStep = 1.2;
/// Distance between the dabs of a stroke, as a fraction of the radius.
constexpr double kPace = 0.25;
constexpr int kMaxDabs = 2000; ///< per pointer movement; longer straight strokes have gaps

double spacingAt(const Shell &context, Vec2 place) {
    return context.preview->spacing ? context.preview->spacing->at(place) : 0.0;
}

struct BrushPlaceHash {
    std::size_t operator()(Vec2 place) const {
        Hash64 hash;
        hash.add(place.x);
        hash.add(place.y);
        return static_cast<std::size_t>(hash.value());
    }
};

/// Returns a function that remembers the values of a field, since the dabs of a stroke overlap.
std::function<double(Vec2)> remembered(std::shared_ptr<const SpacingField> field) {
    auto known = std::make_shared<std::unordered_map<Vec2, double, BrushPlaceHash>>();
    return [field = std::move(field), known](Vec2 place) {
        const auto [entry, isNew] = known->try_emplace(place, 0.0);
        if (isNew) {
            entry->second = field->at(place);
        }
        return entry->second;
    };
}

} // namespace

const char *BrushTool::icon() const {
    return erases_ ? icon::kEraser : icon::kBrush;
}

double BrushTool::radius(const Shell &context) const {
    const double held = state_->held(&EditState::brushRadius, context);
    return held > 0.0 ? held : roundedTo(EditState::reach(context, 36.0), 2);
}

bool BrushTool::followsPointer(const Shell &context) const {
    return pointer_ && !(state_->held(&EditState::brushSpacing, context) > 0.0) && spacingAt(context, *pointer_) > 0.0;
}

double BrushTool::spacing(const Shell &context) const {
    if (const double held = state_->held(&EditState::brushSpacing, context); held > 0.0) {
        return held;
    }
    const Box2 box = boundsOf(*context.document.current());
    const Vec2 middle = box.empty() ? context.view.camera.centre : box.centre();
    const double rho = spacingAt(context, pointer_ ? *pointer_ : middle);
    return roundedTo(rho > 0.0 ? 0.4 * rho : 0.25 * radius(context), 2);
}

void BrushTool::deactivate(Shell &) {
    stroke_.clear();
    pointer_.reset();
    end_.reset();
}

void BrushTool::pick(Vec2 place, Shell &context) {
    const double rho = spacingAt(context, place);
    if (!(rho > 0.0)) {
        context.log.refuse("The drawing has no element sizes yet");
        return;
    }
    state_->brushSpacing = roundedTo(rho, 2);
    context.log.announce("The brush paints \xcf\x81 = " + ui::number(state_->brushSpacing, 3) +
                         unitSuffix(context.document.current()->unit));
}

void BrushTool::begin(const CanvasEvent &event, Shell &context) {
    // From the first stroke on they stay, or strokes over painted places would get finer and finer.
    strokeSpacing_ = spacing(context);
    strokeRadius_ = radius(context);
    state_->propose(&EditState::brushSpacing, strokeSpacing_, context);
    state_->propose(&EditState::brushRadius, strokeRadius_, context);
    stroke_ = state_->newStroke();
    last_ = event.modifiers.shift() ? end_ : std::nullopt;
    around_ = context.preview->spacing ? remembered(context.preview->spacing) : std::function<double(Vec2)>();
    changed_ = false;
    stroke(event.place, context);
}

void BrushTool::forget(Shell &context) {
    deactivate(context);
    state_->forgetNumbers();
}

void BrushTool::scale(double factor, bool spacing, Shell &context) {
    const bool changesSpacing = spacing && sets();
    double &value = changesSpacing ? state_->brushSpacing : state_->brushRadius;
    const double now = changesSpacing ? this->spacing(context) : radius(context);
    value = std::clamp(roundedTo(now * factor, 2), 1e-9, 1e12);
}

bool BrushTool::handle(const CanvasEvent &event, Shell &context) {
    using Kind = CanvasEvent::Kind;
    if (event.kind == Kind::Key) {
        return key(event, context);
    }
    if (event.kind == Kind::Text) {
        return false;
    }
    pointer_ = event.kind == Kind::Leave ? std::nullopt : std::optional(event.place);
    straight_ = event.modifiers.shift() && stroke_.empty();
    picks_ = event.modifiers.control() && stroke_.empty() && sets();
    switch (event.kind) {
    case Kind::Press:
        if (event.button == MouseButton::Left && event.modifiers.control() && sets()) {
            pick(event.place, context);
        } else if (event.button == MouseButton::Left) {
            begin(event, context);
        } else if (event.button == MouseButton::Right) {
            context.selection.clear(); // it is not drawn in this tool, so the menu must not act on it
            context.contextMenu = true;
        }
        return true;
    case Kind::Drag:
        if (!stroke_.empty()) {
            stroke(event.place, context);
        }
        return true;
    case Kind::Release:
        if (!stroke_.empty() && !changed_ && !erases() && !sets()) {
            context.log.refuse("Nothing changed: the drawing has no element sizes yet");
        }
        end_ = stroke_.empty() ? end_ : last_;
        stroke_.clear();
        return true;
    case Kind::Wheel:
        scale(std::pow(kStep, event.wheel), event.modifiers.shift(), context);
        return true;
    default:
        return true;
    }
}

bool BrushTool::key(const CanvasEvent &event, Shell &context) {
    if (event.modifiers.control() || event.modifiers.alt()) {
        return false;
    }
    if (event.key == key::kEscape && !stroke_.empty()) {
        context.document.abandonStroke(std::exchange(stroke_, {}));
        return true;
    }
    return false;
}

bool BrushTool::command(std::string_view word, Shell &context) {
    if (word == "larger" || word == "smaller") {
        scale(word == "larger" ? kStep : 1.0 / kStep, false, context);
        return true;
    }
    if (word == "sizeUp" || word == "sizeDown") {
        scale(word == "sizeUp" ? kStep : 1.0 / kStep, true, context);
        return true;
    }
    const std::optional<DabMode> mode = fromWord<DabMode>(word);
    if (mode && !erases_) {
        state_->brushMode = *mode;
    }
    return mode.has_value();
}

void BrushTool::stroke(Vec2 to, Shell &context) {
    const std::shared_ptr<const Document> document = context.document.current();
    PaintedSpacing painted = document->spacing.paint;
    if (painted.tiles.empty() && !erases()) {
        Box2 box = boundsOf(*document);
        if (box.empty()) {
            box = context.view.camera.visible();
        }
        painted = emptyPaint(box);
        painted.replaces = true;
    }
    if (!painted.replaces && !erases() && around_) {
        painted = replacing(painted, around_); // of an older version; from now on the brush can enlarge sizes, too
    }
    const Vec2 from = last_.value_or(to);
    const double pace = kPace * strokeRadius_;
    const int dabs = last_ ? std::clamp(static_cast<int>(distance(from, to) / pace), 0, kMaxDabs) : 1;
    if (dabs == 0) {
        return; // too short; the next movement continues from the same place
    }
    for (int k = 1; k <= dabs; ++k) {
        const Vec2 at = lerp(from, to, static_cast<double>(k) / dabs);
        painted = paint(painted, dabAt(at));
    }
    last_ = to;
    if (painted.tiles == document->spacing.paint.tiles) {
        return;
    }
    changed_ = true;
    context.document.apply(setPaint(*document, std::move(painted)), label(), stroke_);
}

Dab BrushTool::dabAt(Vec2 place) const {
    Dab dab{.centre = place, .radius = strokeRadius_, .spacing = strokeSpacing_};
    dab.mode = erases() ? DabMode::Erase : state_->brushMode;
    dab.hardness = 1.0 - state_->brushFalloff;
    dab.strength = state_->brushStrength;
    dab.around = around_;
    return dab;
}

const char *BrushTool::label() const {
    if (erases()) {
        return "Erase spacing";
    }
    switch (state_->brushMode) {
    case DabMode::Finer:
        return "Make spacing finer";
    case DabMode::Coarser:
        return "Make spacing coarser";
    case DabMode::Smooth:
        return "Smooth spacing";
    default:
        return "Paint spacing";
    }
}

void BrushTool::drawOverlay(CanvasPainter &painter, Shell &context) {
    if (!pointer_) {
        return;
    }
    const Theme &theme = context.theme;
    if (picks_) {
        const double rho = spacingAt(context, *pointer_);
        const double side = 10.0;
        painter.label(*pointer_, {side, side}, rho > 0.0 ? "pick \xcf\x81=" + ui::number(rho, 3) : "no size here",
                      theme.text, fade(theme.popup, 0.9), context.fonts.small);
        return;
    }
    if (straight_ && end_) {
        painter.dashed(*end_, *pointer_, theme.brush);
    }
    const double ring = stroke_.empty() ? radius(context) : strokeRadius_;
    painter.circle(*pointer_, ring, fade(theme.canvas, 0.7), 3.5);
    painter.circle(*pointer_, ring, theme.brush, 1.75);
    if (!erases()) {
        painter.dashedCircle(*pointer_, (1.0 - state_->brushFalloff) * ring, fade(theme.brush, 0.6), 1.0);
    }
    std::string text = "r=" + ui::number(ring, 3);
    if (!erases_ && !sets()) {
        text += "  " + std::string(wordOf(state_->brushMode));
    } else if (sets()) {
        text += "  \xcf\x81=" + ui::number(stroke_.empty() ? spacing(context) : strokeSpacing_, 3);
        text += stroke_.empty() && followsPointer(context) ? ", 0.4 of the size here" : "";
    }
    // Beside the ring, but no farther away than its width on the screen.
    const double beside = std::min(0.71 * ring * context.view.camera.zoom / painter.scale(), 160.0) + 8.0;
    painter.label(*pointer_, {beside, beside}, text, theme.text, fade(theme.popup, 0.9), context.fonts.small);
}

/// Draws the options for mode, strength and falloff.
void BrushTool::drawModes(Shell &context, ui::Flow &flow) {
    flow.item("mode");
    int mode = static_cast<int>(state_->brushMode);
    ui::combo(context, "options/brush/mode", ui::enumLabels<DabMode>(), mode, 92.0F);
    state_->brushMode = static_cast<DabMode>(mode);
    ui::tooltip(context,
                "Set: paint a spacing. Finer, coarser: reduce or enlarge the current spacing. Smooth: even it out. "
                "Erase: remove paint. Paint replaces other sizes, but not those of boundary parts, nodes and regions.");
    if (erases()) {
        return;
    }
    double strength = state_->brushStrength, falloff = state_->brushFalloff;
    if (drawSizeOption(context, flow, "options/brush/strength", "Strength", strength,
                       "Effect of one stroke, from 0 to 1")) {
        state_->brushStrength = std::min(strength, 1.0);
    }
    if (drawLengthOption(context, flow, "options/brush/falloff", "Falloff", falloff,
                         "Fraction of the radius over which the stroke fades, from 0 to 1")) {
        state_->brushFalloff = std::min(falloff, 1.0);
    }
}

void BrushTool::drawOptions(Shell &context, ui::Flow &flow) {
    if (double shown = radius(context);
        drawSizeOption(context, flow, "options/brush/radius", "Radius", shown,
                       "Brush radius. Also [ and ], or Ctrl + wheel.", context.document.current()->unit)) {
        state_->brushRadius = shown;
    }
    if (!erases_) {
        drawModes(context, flow);
    }
    if (sets()) {
        if (double shown = spacing(context); drawSizeOption(
                context, flow, "options/brush/spacing", "Spacing \xcf\x81", shown,
                "Element size to paint. Until the first stroke it is 0.4 of the size under the pointer; enter a number "
                "to paint that one. Also Shift + [ and ], or Shift + wheel.",
                context.document.current()->unit)) {
            state_->brushSpacing = shown;
        }
    }
    flow.item("clear");
    const bool painted = !context.document.current()->spacing.paint.tiles.empty();
    if (ui::button(context, "options/brush/clear", "Clear paint", ui::ButtonKind::Plain, painted)) {
        context.actions.run("edit.clearPaint", context);
    }
}

std::string BrushTool::statusText(const Shell &) const {
    return erases() ? "Drag to erase painted spacing; Shift+click: straight from the last stroke. [ ]: radius"
           : sets() ? "Drag to paint; Shift+click: straight from the last stroke; Ctrl+click: pick a size. [ ]: radius"
                    : "Drag to paint; Shift+click: straight from the last stroke. [ ] or Ctrl+wheel: radius";
}

} // namespace forefront
