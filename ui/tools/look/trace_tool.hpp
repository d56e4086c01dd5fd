#pragma once

#include "ui/parts/tool.hpp"

namespace forefront {

/// Traces how the mesh was made: a click goes to the advance that made an element, edge or node, or sets a breakpoint
/// at a point or at a cell of the background grid.
class TraceTool final : public Tool {
  public:
    const char *id() const override { return "trace"; }
    const char *name() const override { return "Trace: what made this?"; }
    const char *icon() const override;
    int key() const override { return 'W'; }
    void activate(Shell &context) override;
    bool handle(const CanvasEvent &event, Shell &context) override;
    bool hasOptions(const Shell &) const override { return true; }
    void drawOptions(Shell &context, ui::Flow &flow) override;
    CursorShape cursor() const override { return CursorShape::Crosshair; }
    std::vector<ContextGroup> menu(Shell &context, Vec2 place) override;
    std::string statusText(const Shell &context) const override;

  private:
    static void click(Vec2 place, Shell &context);
};

} // namespace forefront
