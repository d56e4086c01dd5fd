#pragma once

#include "core/engine/spacing/spacing_field.hpp"
#include "ui/parts/tool.hpp"
#include "ui/workspace/edit_state.hpp"

#include <functional>
#include <memory>
#include <optional>

namespace forefront {

/// Paints the node spacing or erases paint. A stroke is one command; the paint is part of the document.
class BrushTool final : public Tool {
  public:
    BrushTool(std::shared_ptr<EditState> state, bool erases) : state_(std::move(state)), erases_(erases) {}

    const char *id() const override { return erases_ ? "eraser" : "brush"; }
    const char *name() const override { return erases_ ? "Eraser: remove paint" : "Brush: paint the spacing"; }
    const char *icon() const override;
    int key() const override { return erases_ ? 'E' : 'B'; }
    CursorShape cursor() const override { return CursorShape::Crosshair; }
    void deactivate(Shell &context) override;
    void forget(Shell &context) override;
    bool handle(const CanvasEvent &event, Shell &context) override;
    void drawOverlay(CanvasPainter &painter, Shell &context) override;
    /// "larger", "smaller": the radius; "sizeUp", "sizeDown": the painted spacing; or the word of a mode.
    bool command(std::string_view word, Shell &context) override;
    bool hasOptions(const Shell &) const override { return true; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    std::string statusText(const Shell &context) const override;

  private:
    bool key(const CanvasEvent &event, Shell &context);
    /// Begins a stroke; with Shift, it goes straight on from the end of the last one.
    void begin(const CanvasEvent &event, Shell &context);
    /// Takes the spacing at a place as the one to paint.
    void pick(Vec2 place, Shell &context);
    /// Paints from the previous place to `to`.
    void stroke(Vec2 to, Shell &context);
    bool erases() const { return erases_ || state_->brushMode == DabMode::Erase; }
    bool sets() const { return !erases_ && state_->brushMode == DabMode::Set; }
    /// Returns a dab at a position with the chosen mode and options.
    Dab dabAt(Vec2 place) const;
    const char *label() const;
    void drawModes(Shell &context, ui::Flow &flow);
    void scale(double factor, bool spacing, Shell &context);
    /// Returns the radius that the user has set, or one that suits the view.
    double radius(const Shell &context) const;
    /// Returns true before the first stroke, while the spacing to paint depends on where the pointer is.
    bool followsPointer(const Shell &context) const;
    /// Returns the spacing that the user has set, or one finer than the present spacing under the pointer.
    double spacing(const Shell &context) const;

    std::shared_ptr<EditState> state_;
    bool erases_;
    std::optional<Vec2> pointer_, last_;
    std::optional<Vec2> end_;                         ///< of the last stroke
    bool straight_ = false, picks_ = false;           ///< Shift or Ctrl is held, as of the last event
    std::string stroke_;                              ///< key of the stroke in progress; empty: none
    std::function<double(Vec2)> around_{};            ///< spacing when the stroke began; empty: none
    double strokeRadius_ = 0.0, strokeSpacing_ = 0.0; ///< of the stroke in progress
    bool changed_ = false;                            ///< the stroke has changed the paint
};

} // namespace forefront
