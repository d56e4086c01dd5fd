#pragma once

#include "ui/tools/common/drawing_tool.hpp"

namespace forefront {

/// Places a point that the mesh must contain.
class PointTool final : public DrawingTool {
  public:
    using DrawingTool::DrawingTool;

    const char *id() const override { return "point"; }
    const char *name() const override { return "Inner point"; }
    const char *icon() const override;
    int key() const override { return 'O'; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    bool hasOptions(const Shell &) const override { return true; }
    std::string statusText(const Shell &) const override {
        return "Click where the mesh must have a node, or type x, Tab, y, Enter";
    }

  protected:
    void place(Vec2 at, Shell &context) override;
    void drawSketch(CanvasPainter &painter, Shell &context) override;
    bool describePath(InferenceQuery &) const override { return true; }
};

} // namespace forefront
