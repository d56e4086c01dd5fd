#include "ui/canvas/canvas_painter.hpp"
#include "ui/layers/layers.hpp"

#include <cstddef>

namespace forefront {

namespace {

/// Draws the two colours of the nodes of the front of quadrilaterals: discs and rings.
class ColoursLayer final : public Layer {
  public:
    const char *id() const override { return "colours"; }
    const char *name() const override { return "Colours of nodes"; }
    void request(SnapshotLayers &layers) const override { layers.front = true; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        if (!frame.snapshot.front) {
            return;
        }
        const Box2 visible = frame.camera.visible();
        const double pixel = frame.camera.zoom / frame.scale;
        std::size_t drawn = 0;
        for (const FrontSegmentView &segment : *frame.snapshot.front) {
            const bool isWide = pixel * distance(segment.a, segment.b) > kMinSegment;
            if (segment.colour < 0 || !isWide || !visible.contains(segment.a)) {
                continue;
            }
            painter.dot(segment.a, kRadius, segment.colour == 1 ? frame.theme.front : frame.theme.domain);
            painter.ring(segment.a, kRadius, frame.theme.front, 1.5);
            if (++drawn == kMaxNodes) {
                break;
            }
        }
    }

  private:
    static constexpr double kRadius = 4.0, kMinSegment = 14.0; ///< design pixels
    static constexpr std::size_t kMaxNodes = 4000;
};

} // namespace

std::unique_ptr<Layer> makeColoursLayer() {
    return std::make_unique<ColoursLayer>();
}

} // namespace forefront
