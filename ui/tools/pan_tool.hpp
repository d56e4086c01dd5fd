#pragma once

#include "ui/tools/tool.hpp"

namespace forefront {

/// Moves the view, for those without a middle button.
class PanTool final : public Tool {
  public:
    const char *id() const override { return "pan"; }
    const char *name() const override { return "Move the view"; }
    const char *icon() const override;
    int key() const override { return 'H'; }
    bool handle(const CanvasEvent &event, AppContext &context) override;
    std::string statusText(const AppContext &context) const override;

  private:
    Vec2 grabbed_;
};

} // namespace forefront
