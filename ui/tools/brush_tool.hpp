#pragma once

#include "ui/tools/edit_state.hpp"
#include "ui/tools/tool.hpp"

#include <memory>
#include <optional>

namespace forefront {

/// Paints the node spacing or erases paint. A stroke is one command; the paint is part of the document.
class BrushTool final : public Tool {
  public:
    BrushTool(std::shared_ptr<EditState> state, bool erases) : state_(std::move(state)), erases_(erases) {}

    const char *id() const override { return erases_ ? "eraser" : "brush"; }
    const char *name() const override { return erases_ ? "Eraser: wipe painted spacing" : "Brush: paint the spacing"; }
    const char *icon() const override;
    int key() const override { return erases_ ? 'E' : 'B'; }
    CursorShape cursor() const override { return CursorShape::Crosshair; }
    void activate(AppContext &context) override;
    void deactivate(AppContext &context) override;
    bool handle(const CanvasEvent &event, AppContext &context) override;
    void drawOverlay(CanvasPainter &painter, AppContext &context) override;
    bool hasOptions(const AppContext &) const override { return true; }
    void drawOptions(AppContext &context, ui::Flow &flow) override;
    std::string statusText(const AppContext &context) const override;

  private:
    bool key(const CanvasEvent &event, AppContext &context);
    /// Paints from the previous place to `to`.
    void stroke(Vec2 to, AppContext &context);
    void scale(double factor, bool spacing, AppContext &context);
    /// Derives radius and spacing that the user has not set from the view and the current spacing.
    void settle(AppContext &context);

    std::shared_ptr<EditState> state_;
    bool erases_;
    std::optional<Vec2> pointer_, last_;
    std::string stroke_; ///< key of the stroke in progress; empty: none
    double ambient_ = 0.0;
};

} // namespace forefront
