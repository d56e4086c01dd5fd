#include "core/teaching/moment/moment.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/canvas/line_density.hpp"
#include "ui/gl/gl_kit.hpp"
#include "ui/gl/line_batch.hpp"
#include "ui/layers/advance_labels.hpp"
#include "ui/layers/layers.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

std::string nodeLabel(const char *letter, NodeId node) {
    return node == kNoNode ? std::string(letter) : letter + (" " + std::to_string(index(node)));
}

class FrontLayer final : public Layer {
  public:
    const char *id() const override { return "front"; }
    const char *name() const override { return "Front \xce\x93"; }
    void request(SnapshotLayers &layers) const override {
        layers.front = true;
        layers.explanation = true;
    }

    void drawLive(const LayerFrame &frame) override {
        const Moment moment = momentOf(frame.snapshot);
        const std::optional<Vec2> middle =
            moment ? std::optional(midpoint(moment.advance->a, moment.advance->b)) : std::nullopt;
        if (frame.snapshot.front != shown_ || theme_ != frame.theme.kind || middle != base_) {
            shown_ = frame.snapshot.front;
            theme_ = frame.theme.kind;
            base_ = middle;
            update(frame.theme.front);
        }
        // The front may be twice as wide as the edges of the mesh, which it must not be taken for.
        const double width = densityWidth(2.0 * frame.camera.zoom * meanLength_, 2.2 * frame.scale);
        rest_.draw(frame.gl, frame.camera, {.width = width});
        near_.draw(frame.gl, frame.camera, {.width = width, .arrow = 7.0 * frame.scale});
    }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        drawBreakpoints(painter, frame);
        const Moment moment = momentOf(frame.snapshot);
        if (!moment) {
            return;
        }
        const AdvanceExplanation &e = *moment.advance;
        const Theme &theme = frame.theme;
        const double pixels = frame.camera.zoom * distance(e.a, e.b) / frame.roomScale;
        painter.line(e.a, e.b, theme.base, 5.0);
        painter.dot(e.a, 4.5, theme.base);
        painter.dot(e.b, 4.5, theme.base);
        painter.line(e.a, e.b, theme.core, 1.4);
        if (pixels < 14.0) {
            painter.ring(midpoint(e.a, e.b), 13.0, theme.base, 2.0); // too small to find otherwise
        }
        if (pixels > kLabelledBase) {
            // Beyond the ends, on the meshed side, which has no candidates.
            const Vec2 along = e.b - e.a;
            const Vec2 right{along.y, -along.x};
            labelOfAdvance(painter, frame, moment, {e.a, right - along, nodeLabel("A", e.nodeA), theme.base});
            labelOfAdvance(painter, frame, moment, {e.b, right + along, nodeLabel("B", e.nodeB), theme.base});
        }
    }

  private:
    /// Number of segments nearest to the base that are drawn at full strength, with arrows.
    static constexpr std::size_t kNear = 12;
    static constexpr double kFar = 0.45; ///< opacity of the others

    /// Divides the front into the part near the base, where the action is, and the rest. Without a base, all of it is
    /// at full strength.
    void update(Colour colour) {
        rest_.clear();
        near_.clear();
        meanLength_ = 0.0;
        if (!shown_) {
            return;
        }
        std::vector<std::pair<double, std::size_t>> order; // by distance from the base
        for (std::size_t k = 0; k < shown_->size(); ++k) {
            const FrontSegmentView &segment = (*shown_)[k];
            meanLength_ += distance(segment.a, segment.b) / static_cast<double>(shown_->size());
            order.emplace_back(base_ ? distance(midpoint(segment.a, segment.b), *base_) : 0.0, k);
        }
        const std::size_t near = base_ ? std::min(kNear, order.size()) : 0;
        std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(near), order.end());
        for (std::size_t i = 0; i < order.size(); ++i) {
            const FrontSegmentView &segment = (*shown_)[order[i].second];
            (i < near ? near_ : rest_).add(segment.a, segment.b, base_ && i >= near ? fade(colour, kFar) : colour);
        }
    }

    /// Marks the point and the cell that stop the run.
    static void drawBreakpoints(CanvasPainter &painter, const LayerFrame &frame) {
        const Breakpoints &breakpoints = frame.breakpoints;
        if (breakpoints.has(StopKind::Place) && breakpoints.place) {
            painter.ring(*breakpoints.place, 9.0, frame.theme.accent, 2.0);
            painter.cross(*breakpoints.place, 6.0, frame.theme.accent, 2.0);
        }
        if (breakpoints.has(StopKind::Cell) && breakpoints.cell) {
            painter.rectangle(*breakpoints.cell, frame.theme.accent, 2.5);
        }
    }

    LineBatch rest_, near_;
    std::optional<Vec2> base_; ///< middle of the base that `near_` belongs to
    double meanLength_ = 0.0;  ///< of the segments, in domain units
    std::shared_ptr<const std::vector<FrontSegmentView>> shown_;
    ThemeKind theme_ = ThemeKind::Dark;
};

class GridLayer final : public Layer {
  public:
    const char *id() const override { return "grid"; }
    const char *name() const override { return "Grid cells"; }
    void request(SnapshotLayers &layers) const override {
        layers.cells = true;
        layers.explanation = true;
    }

    void drawLive(const LayerFrame &frame) override {
        if (frame.snapshot.cells != shown_ || theme_ != frame.theme.kind) {
            shown_ = frame.snapshot.cells;
            theme_ = frame.theme.kind;
            occupied_.clear();
            smallest_ = std::numeric_limits<double>::infinity();
            if (shown_) {
                for (const GridCellView &cell : *shown_) {
                    const double weight = cell.entries == 0 ? 0.0 : 0.10 + 0.05 * std::min<double>(cell.entries, 8.0);
                    occupied_.add(cell.box, fade(frame.theme.cell, weight), fade(frame.theme.cell, 0.45));
                    smallest_ = std::min({smallest_, cell.box.size().x, cell.box.size().y});
                }
            }
        }
        occupied_.draw(frame.gl, frame.camera, densityWidth(frame.camera.zoom * smallest_, 1.0 * frame.scale));
        visited_.clear();
        if (const Moment moment = momentOf(frame.snapshot)) {
            for (std::size_t i = 0; i < moment.cells; ++i) {
                visited_.add(moment.advance->cells[i], fade(frame.theme.visited, 0.24), fade(frame.theme.visited, 0.9));
            }
        }
        visited_.draw(frame.gl, frame.camera, 1.5 * frame.scale);
    }

  private:
    BoxBatch occupied_, visited_;
    double smallest_ = 0.0; ///< side of the occupied cells, in domain units
    std::shared_ptr<const std::vector<GridCellView>> shown_;
    ThemeKind theme_ = ThemeKind::Dark;
};

} // namespace

std::unique_ptr<Layer> makeFrontLayer() {
    return std::make_unique<FrontLayer>();
}

std::unique_ptr<Layer> makeGridLayer() {
    return std::make_unique<GridLayer>();
}

} // namespace forefront
