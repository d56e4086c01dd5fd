#pragma once

#include "core/drawing/picking/face_map.hpp"
#include "ui/tools/common/drawing_tool.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

/// Makes faces regions. A click in a face without a region gives it a new one, a click in another face selects its
/// region; with a chosen tag, a click gives any face that region.
class RegionTool final : public DrawingTool {
  public:
    using DrawingTool::DrawingTool;

    const char *id() const override { return "region"; }
    const char *name() const override { return "Region: click in a face"; }
    const char *icon() const override;
    int key() const override { return 'G'; }
    void deactivate(Shell &context) override;
    void forget(Shell &context) override;
    void drawOptions(Shell &context, ui::Flow &flow) override;
    bool hasOptions(const Shell &) const override { return true; }
    std::string statusText(const Shell &context) const override;
    /// Offers to name the face at a place, which becomes a region if it is none, and the commands on its region.
    std::vector<ContextGroup> menu(Shell &context, Vec2 place) override;

  protected:
    void place(Vec2 at, Shell &context) override;
    void drawSketch(CanvasPainter &painter, Shell &context) override;
    bool snaps() const override { return false; }
    void pointed(Shell &context) override;

  private:
    /// Returns the tag that a click gives a face.
    std::int32_t tagOfNext(const Shell &context) const;
    /// Returns the region marker in a face that a click selects, if it does.
    std::optional<std::uint32_t> selectable(const MappedFace &face) const;
    std::string labelOf(const MappedFace &face, const Shell &context) const;

    std::optional<std::int32_t> tag_; ///< chosen for the next faces; absent: a free one
};

} // namespace forefront
