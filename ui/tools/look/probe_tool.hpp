#pragma once

#include "ui/parts/tool.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

struct Judgement;

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
    void drawOverlay(CanvasPainter &painter, Shell &context) override;
    std::string statusText(const Shell &context) const override;

  private:
    void find(Shell &context);

    std::optional<Vec2> place_;                 ///< of the pointer
    std::shared_ptr<const Judgement> searched_; ///< the part under the pointer was sought in it
};

} // namespace forefront
