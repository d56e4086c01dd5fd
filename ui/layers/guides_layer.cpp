#include "core/drawing/document/document.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/layers/layers.hpp"

#include <string>

namespace forefront {

namespace {

/// Draws the guides of the document across the whole view.
class GuidesLayer final : public Layer {
  public:
    const char *id() const override { return "guides"; }
    const char *name() const override { return "Guides"; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        const Box2 visible = frame.camera.visible();
        for (const Guide &guide : frame.document.guides) {
            const Vec2 from = guide.upright ? Vec2{guide.at, visible.min.y} : Vec2{visible.min.x, guide.at};
            const Vec2 to = guide.upright ? Vec2{guide.at, visible.max.y} : Vec2{visible.max.x, guide.at};
            if (boxOf(from, to).overlaps(visible)) {
                painter.dashed(from, to, fade(frame.theme.constraint, 0.8), 1.0, 8.0);
            }
        }
    }
};

} // namespace

std::unique_ptr<Layer> makeGuidesLayer() {
    return std::make_unique<GuidesLayer>();
}

} // namespace forefront
