#include "core/engine/domain/domain.hpp"
#include "core/engine/layers/layer_report.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/layers/layers.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace forefront {

namespace {

constexpr std::size_t kMaxLines = 20'000; ///< rays drawn; more would be a grey band
constexpr std::size_t kMaxNotes = 200;    ///< shortened rays with a label
constexpr double kMinLine = 3.0;          ///< design pixels of a ray worth drawing
constexpr double kMinNoted = 16.0;        ///< ... and worth a label

/// Returns what a shortened ray says: its layers, those asked for, and what stopped it.
std::string noteOf(const ShortenedRay &ray, const LayerFrame &frame) {
    const std::string count = std::to_string(ray.made) + " of " + std::to_string(ray.asked);
    const std::string name = boundaryName(frame.document.boundaryNames, ray.stoppedBy);
    switch (ray.stop) {
    case LayerStop::Wall:
        return count + ": near " + name;
    case LayerStop::Point:
        return count + ": near a point";
    case LayerStop::End:
        return count + ": end beside " + name;
    case LayerStop::Fold:
        return count + ": would fold";
    case LayerStop::Meeting:
        return count + ": would meet " + name;
    }
    return count;
}

/// Draws the rays of boundary layers, the number of their layers, and those that are shorter than asked for with what
/// stopped them. Before a run, and once the drawing has changed, they are planned ones, with their rows.
class BoundaryLayersLayer final : public Layer {
  public:
    const char *id() const override { return "rays"; }
    const char *name() const override { return "Boundary layers"; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        const bool isMade = frame.snapshot.layers != nullptr && !frame.outOfDate;
        const LayerReport *const report = isMade ? frame.snapshot.layers.get() : &frame.layerPlan->rows.report;
        const Box2 visible = frame.camera.visible();
        if (!isMade) {
            drawRows(painter, frame, frame.layerPlan->rows, visible);
        }
        std::size_t drawn = 0;
        for (const LayerLine &line : report->lines) {
            if (drawn < kMaxLines && isSeen(frame, visible, line.base, line.end, kMinLine)) {
                painter.line(line.base, line.end, fade(frame.theme.constraint, 0.7), 1.0);
                ++drawn;
            }
        }
        drawShortened(painter, frame, *report, visible);
        drawCounts(painter, frame, *report, visible);
    }

  private:
    static bool isSeen(const LayerFrame &frame, const Box2 &visible, Vec2 from, Vec2 to, double pixels) {
        return boxOf(from, to).overlaps(visible) && frame.camera.zoom * distance(from, to) >= pixels * frame.scale;
    }

    /// Draws the rows, those closer than a few pixels to the one below left out.
    static void drawRows(CanvasPainter &painter, const LayerFrame &frame, const LayerRows &rows, const Box2 &visible) {
        constexpr double kApart = 3.0; // design pixels
        std::size_t drawn = 0;
        std::optional<Vec2> below;
        for (const auto &[from, to] : rows.pieces) {
            const bool isApart = !below || frame.camera.zoom * distance(*below, from) >= kApart * frame.scale;
            if (drawn == kMaxLines || !isApart || !isSeen(frame, visible, from, to, kMinLine)) {
                continue;
            }
            painter.line(from, to, fade(frame.theme.constraint, 0.45), 1.0);
            below = from;
            ++drawn;
        }
    }

    static void drawShortened(CanvasPainter &painter, const LayerFrame &frame, const LayerReport &report,
                              const Box2 &visible) {
        std::size_t notes = 0;
        for (const ShortenedRay &ray : report.shortened) {
            if (!isSeen(frame, visible, ray.base, ray.end, kMinLine)) {
                continue;
            }
            painter.line(ray.base, ray.end, frame.theme.warn, 2.0);
            painter.cross(ray.end, 3.0, frame.theme.warn);
            if (notes < kMaxNotes && isSeen(frame, visible, ray.base, ray.end, kMinNoted) &&
                painter.freeLabel(ray.end, Pixel(8.0, -8.0), noteOf(ray, frame), frame.theme.text,
                                  fade(frame.theme.popup, 0.9), frame.fonts.small)) {
                ++notes;
            }
        }
    }

    /// Writes the number of layers at the first ray and wherever it changes along a wall, but not at shortened rays,
    /// which say it themselves; they come in the same order.
    static void drawCounts(CanvasPainter &painter, const LayerFrame &frame, const LayerReport &report,
                           const Box2 &visible) {
        std::size_t notes = 0;
        const LayerLine *before = nullptr;
        auto shortened = report.shortened.begin();
        for (const LayerLine &line : report.lines) {
            const bool changes = before == nullptr || before->layers != line.layers;
            before = &line;
            if (shortened != report.shortened.end() && shortened->base == line.base) {
                ++shortened;
                continue;
            }
            if (changes && notes < kMaxNotes && isSeen(frame, visible, line.base, line.end, kMinNoted) &&
                painter.freeLabel(line.end, Pixel(8.0, -8.0), std::to_string(line.layers), frame.theme.muted,
                                  fade(frame.theme.popup, 0.82), frame.fonts.small)) {
                ++notes;
            }
        }
    }
};

} // namespace

std::unique_ptr<Layer> makeBoundaryLayersLayer() {
    return std::make_unique<BoundaryLayersLayer>();
}

} // namespace forefront
