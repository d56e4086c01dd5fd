#pragma once

#include "ui/parts/tool.hpp"

#include <string>

namespace forefront {

/// Reads values from the mesh: the part under the pointer, and the part that is clicked.
class ProbeTool final : public Tool {
  public:
    const char *id() const override { return "probe"; }
    const char *name() const override { return "Probe the mesh"; }
    const char *icon() const override;
    int key() const override { return 'I'; }
    CursorShape cursor() const override;
    void activate(Shell &context) override;
    void deactivate(Shell &context) override;
    bool handle(const CanvasEvent &event, Shell &context) override;
    std::vector<ContextGroup> menu(Shell &context, Vec2 place) override;
    std::string statusText(const Shell &context) const override;
};

} // namespace forefront
