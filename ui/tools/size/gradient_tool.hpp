#pragma once

#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "ui/tools/common/drawing_tool.hpp"

namespace forefront {

/// Draws a gradient of the element size between two ends: over the whole plane as a size source, whose ends can be
/// dragged later, or inside the selected shapes as paint.
class GradientTool final : public DrawingTool {
  public:
    using DrawingTool::DrawingTool;

    const char *id() const override { return "gradient"; }
    const char *name() const override { return "Gradient: sizes from end to end"; }
    const char *icon() const override;
    int key() const override { return 'D'; }
    bool hasOptions(const Shell &) const override { return true; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    std::string statusText(const Shell &context) const override;

  protected:
    void place(Vec2 at, Shell &context) override;
    std::string_view goal() const override { return first_ ? "add the gradient" : "place the first end"; }
    void drawSketch(CanvasPainter &painter, Shell &context) override;
    std::optional<Vec2> anchor() const override { return first_; }
    void cancel() override { first_.reset(); }
    bool dragPlaces() const override { return true; }
    bool showsSelection() const override { return state_->gradientInSelection; }

  private:
    /// Returns the gradient between two places, with the chosen sizes or those proposed for the drawing.
    SizeSource gradient(Vec2 a, Vec2 b, const Shell &context) const;
    void addSource(Shell &context, SizeSource gradient);
    void paintSelection(Shell &context, const SizeSource &gradient);

    std::optional<Vec2> first_;
};

} // namespace forefront
