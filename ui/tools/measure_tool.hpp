#pragma once

#include "ui/tools/drawing_tool.hpp"

#include <vector>

namespace forefront {

/// Measures from point to point: distance, differences of the coordinates, angle. Draws nothing into the document.
class MeasureTool final : public DrawingTool {
  public:
    using DrawingTool::DrawingTool;

    const char *id() const override { return "measure"; }
    const char *name() const override { return "Measure"; }
    const char *icon() const override;
    int key() const override { return 'M'; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    bool hasOptions(const Shell &) const override { return true; }
    std::string statusText(const Shell &context) const override;
    /// Returns what is measured: "5   Δx 3   Δy 4   ∠ 53.1°"; empty before the first point.
    std::string reading() const;

  protected:
    void place(Vec2 at, Shell &context) override;
    void drawSketch(CanvasPainter &painter, Shell &context) override;
    std::optional<Vec2> anchor() const override {
        return points_.size() == 1 ? std::optional(points_.front()) : std::nullopt;
    }
    void cancel() override { points_.clear(); }
    bool dragPlaces() const override { return true; }

  private:
    std::vector<Vec2> points_; ///< at most two
};

} // namespace forefront
