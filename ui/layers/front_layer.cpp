#include "ui/canvas/canvas_painter.hpp"
#include "ui/gl/gl_kit.hpp"
#include "ui/gl/line_batch.hpp"
#include "ui/layers/layers.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/view/moment.hpp"

#include <string>

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
        if (frame.snapshot.front != shown_ || theme_ != frame.theme.kind) {
            shown_ = frame.snapshot.front;
            theme_ = frame.theme.kind;
            segments_.clear();
            meanLength_ = 0.0;
            if (shown_) {
                for (const FrontSegmentView &segment : *shown_) {
                    segments_.add(segment.a, segment.b, frame.theme.front);
                    meanLength_ += distance(segment.a, segment.b) / static_cast<double>(shown_->size());
                }
            }
        }
        // On segments only a few pixels long, glow and arrows would hide the front and cost time.
        const bool fine = frame.camera.zoom * meanLength_ < 4.0 * frame.scale;
        segments_.draw(frame.gl, frame.camera,
                       {.width = (fine ? 1.25 : 2.0) * frame.scale,
                        .glow = fine ? 0.0 : 9.0 * frame.scale,
                        .arrow = fine ? 0.0 : 7.0 * frame.scale});
    }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        drawBreakpoints(painter, frame);
        const Moment moment = momentOf(frame.snapshot);
        if (!moment) {
            return;
        }
        const AdvanceExplanation &e = *moment.advance;
        const Theme &theme = frame.theme;
        const double pixels = frame.camera.zoom * distance(e.a, e.b) / frame.scale;
        painter.line(e.a, e.b, fade(theme.base, 0.25), 9.0);
        painter.arrow(e.a, e.b, theme.base, 3.0, 11.0);
        if (pixels < 14.0) {
            painter.ring(midpoint(e.a, e.b), 13.0, theme.base, 2.0); // too small to find otherwise
        }
        if (pixels > 60.0) {
            const Colour plate = fade(theme.popup, 0.85);
            // Place the labels beyond the ends, on the meshed side, clear of all candidates. On the screen y points
            // down.
            const Vec2 along = (1.0 / distance(e.a, e.b)) * (e.b - e.a);
            const Vec2 right{along.y, -along.x};
            const auto screen = [](Vec2 v) { return Pixel(v.x, -v.y); };
            const Pixel middle{-9.0, -7.0};
            painter.label(e.a, middle + screen(16.0 * right + -14.0 * along), nodeLabel("A", e.nodeA), theme.base,
                          plate, frame.fonts.small);
            painter.label(e.b, middle + screen(16.0 * right + 14.0 * along), nodeLabel("B", e.nodeB), theme.base, plate,
                          frame.fonts.small);
        }
    }

  private:
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

    LineBatch segments_;
    double meanLength_ = 0.0; ///< of the segments, in domain units
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
            if (shown_) {
                for (const GridCellView &cell : *shown_) {
                    const double weight = cell.entries == 0 ? 0.0 : 0.10 + 0.05 * std::min<double>(cell.entries, 8.0);
                    occupied_.add(cell.box, fade(frame.theme.cell, weight), fade(frame.theme.cell, 0.45));
                }
            }
        }
        occupied_.draw(frame.gl, frame.camera, 1.0 * frame.scale);
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
