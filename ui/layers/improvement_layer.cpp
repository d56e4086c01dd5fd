#include "ui/canvas/canvas_painter.hpp"
#include "ui/layers/layers.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// Maximum number of moves drawn; more would hide the mesh.
constexpr std::size_t kMaxMoves = 4000;

/// Draws what a step of the improvement changed: edges and nodes that came and went, elements made, nodes that moved.
class ImprovementLayer final : public Layer {
  public:
    const char *id() const override { return "improvement"; }
    const char *name() const override { return "Improvement"; }
    void request(SnapshotLayers &layers) const override { layers.mesh = true; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        if (!frame.snapshot.improvement) {
            return;
        }
        const ImproveStep &step = *frame.snapshot.improvement;
        const double arrived = 1.0 - frame.fresh; // the mesh is on its way until then
        for (const StepElement &element : step.elements) {
            const Colour fill = fade(frame.theme.accepted, 0.25 * arrived);
            if (element.count == 4) {
                painter.quadrilateral(element.at, fill);
            } else {
                painter.triangle(element.at[0], element.at[1], element.at[2], fill);
            }
        }
        drawMoves(painter, frame, step);
        for (const auto &[a, b] : step.removedEdges) {
            painter.dashed(a, b, frame.theme.bad, 1.75);
        }
        for (const auto &[a, b] : step.addedEdges) {
            painter.line(a, b, fade(frame.theme.accepted, 0.2 + 0.8 * arrived), 2.0);
        }
        drawNodes(painter, frame, step);
    }

  private:
    /// Draws each move that can be seen as a line to the node, which is where it has moved.
    static void drawMoves(CanvasPainter &painter, const LayerFrame &frame, const ImproveStep &step) {
        constexpr double kVisible = 1.0, kNodeShown = 6.0; // design pixels
        const Box2 visible = frame.camera.visible();
        const double pixel = frame.camera.zoom / frame.scale;
        std::size_t drawn = 0;
        for (const ImproveStep::Move &move : step.moves) {
            const double length = pixel * distance(move.from, move.to);
            if (length < kVisible || !boxOf(move.from, move.to).overlaps(visible)) {
                continue;
            }
            painter.line(move.from, move.to, frame.theme.accepted, 2.0);
            if (length > kNodeShown) {
                painter.dot(move.to, 2.5, frame.theme.accepted);
            }
            if (++drawn == kMaxMoves) {
                break;
            }
        }
    }

    static void drawNodes(CanvasPainter &painter, const LayerFrame &frame, const ImproveStep &step) {
        constexpr double kRadius = 6.5;
        for (const Vec2 node : step.addedNodes) {
            painter.dot(node, kRadius + 1.0, frame.theme.accepted);
            painter.tick(node, kRadius, frame.theme.canvas, 1.75);
        }
        for (const Vec2 node : step.removedNodes) {
            painter.dot(node, kRadius, fade(frame.theme.domain, 0.85));
            painter.ring(node, kRadius, frame.theme.bad, 1.75);
            painter.cross(node, 0.45 * kRadius, frame.theme.bad, 1.5);
        }
    }
};

} // namespace

std::unique_ptr<Layer> makeImprovementLayer() {
    return std::make_unique<ImprovementLayer>();
}

} // namespace forefront
