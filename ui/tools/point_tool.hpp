#pragma once

#include "ui/tools/drawing_tool.hpp"

namespace forefront {

/// Places a point that the mesh must contain.
class PointTool final : public DrawingTool {
  public:
    using DrawingTool::DrawingTool;

    const char *id() const override { return "point"; }
    const char *name() const override { return "Constraint point"; }
    const char *icon() const override;
    int key() const override { return 'O'; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    bool hasOptions(const Shell &) const override { return true; }
    std::string statusText(const Shell &) const override {
        return "Click where the mesh must have a node, or type x, Tab, y";
    }

  protected:
    void place(Vec2 at, Shell &context) override;
    void drawSketch(CanvasPainter &painter, Shell &context) override;
};

/// Names regions: a click fills the face under the pointer with the chosen region.
class RegionTool final : public DrawingTool {
  public:
    using DrawingTool::DrawingTool;

    const char *id() const override { return "region"; }
    const char *name() const override { return "Region: click to fill"; }
    const char *icon() const override;
    int key() const override { return 'G'; }
    void activate(Shell &context) override;
    void drawOptions(Shell &context, ui::Flow &flow) override;
    bool hasOptions(const Shell &) const override { return true; }
    std::string statusText(const Shell &) const override {
        return "Click a face to assign it to this region; faces without a region belong to region 1";
    }

  protected:
    void place(Vec2 at, Shell &context) override;
    void drawSketch(CanvasPainter &painter, Shell &context) override;
    std::optional<Vec2> ownSnap(Vec2 at, const Shell &) const override { return at; }

  private:
    std::int32_t tag_ = 0;
};

} // namespace forefront
