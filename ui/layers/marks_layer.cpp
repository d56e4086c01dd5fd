#include "core/edit/document.hpp"
#include "core/edit/shape_geometry.hpp"
#include "core/edit/spacing_commands.hpp"
#include "core/spacing/spec/source_box.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/canvas/region_label.hpp"
#include "ui/layers/layers.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace forefront {

namespace {

/// Maximum number of marks drawn in view, and of labels; more would be clutter.
constexpr int kMaxSpacingMarks = 600;
constexpr int kMaxSpacingLabels = 40;

/// Draws size sources, sizes at nodes and region markers.
class MarksLayer final : public Layer {
  public:
    const char *id() const override { return "marks"; }
    const char *name() const override { return "Marks"; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        const Box2 visible = frame.camera.visible();
        int drawn = 0;
        const std::vector<SizeSource> &sources = frame.document.spacing.sources;
        for (std::size_t k = 0; k < sources.size() && drawn < kMaxSpacingMarks; ++k) {
            if (boxOfSource(sources[k]).overlaps(visible)) {
                drawSource(painter, frame, k, drawn++ < kMaxSpacingLabels);
            }
        }
        drawn = 0;
        for (const auto &shape : frame.document.shapes) {
            if (!shape->nodeSizes.empty() && !shape->hidden && drawn < kMaxSpacingMarks) {
                drawNodeSizes(painter, frame, *shape, drawn);
            }
        }
        drawn = 0;
        for (std::size_t k = 0; k < frame.document.regionMarkers.size(); ++k) {
            const RegionMarker &marker = frame.document.regionMarkers[k];
            if (visible.contains(marker.at) && drawn < kMaxSpacingMarks) {
                drawMarker(painter, frame, marker, k, drawn++ < kMaxSpacingLabels);
            }
        }
    }

  private:
    static Box2 boxOfSource(const SizeSource &source) {
        Box2 box = boxAround(source.a, source.radius);
        if (source.shape == SourceShape::Line) {
            box.add(boxAround(source.b, source.radius));
        } else if (source.shape == SourceShape::Box) {
            for (const Vec2 corner : SourceBox(source).corners()) {
                box.add(boxAround(corner, source.radius));
            }
        }
        return box;
    }

    /// Draws how far from a line or box its full size reaches: the outline around it at the distance `radius`.
    static void drawReach(CanvasPainter &painter, std::vector<Vec2> corners, double radius, Colour colour) {
        const std::size_t count = corners.size();
        if (count > 2 && cross(corners[1] - corners[0], corners[2] - corners[1]) < 0.0) {
            std::reverse(corners.begin(), corners.end()); // counter-clockwise
        }
        std::vector<Vec2> outline;
        for (std::size_t k = 0; k < count; ++k) {
            const Vec2 in = corners[k] - corners[(k + count - 1) % count], out = corners[(k + 1) % count] - corners[k];
            const double from = std::atan2(-in.x, in.y), bend = std::atan2(cross(in, out), dot(in, out));
            const double turn = count == 2 ? std::numbers::pi : bend; // at an end of a line, half around
            constexpr int kSteps = 16;
            for (int i = 0; i <= kSteps; ++i) {
                const double angle = from + turn * i / kSteps;
                outline.push_back(corners[k] + radius * Vec2{std::cos(angle), std::sin(angle)});
            }
        }
        painter.polyline(outline, true, colour, 1.0);
    }

    static void drawSource(CanvasPainter &painter, const LayerFrame &frame, std::size_t index, bool labelled) {
        const SizeSource &source = frame.document.spacing.sources[index];
        const Colour colour = frame.theme.brush;
        if (source.shape == SourceShape::Line) {
            painter.line(source.a, source.b, fade(colour, 0.8), 2.0);
            painter.dot(source.b, 3.0, colour);
            if (source.radius > 0.0) {
                drawReach(painter, {source.a, source.b}, source.radius, fade(colour, 0.5));
            }
            if (labelled && source.endSize) {
                painter.ring(source.b, 6.5, fade(colour, 0.8), 1.25);
                painter.freeLabel(source.b, {10.0, -18.0}, ui::format("\xcf\x81=%.3g", *source.endSize),
                                  frame.theme.text, fade(frame.theme.popup, 0.75), frame.fonts.small);
            }
        }
        Vec2 at = source.a;
        if (source.shape == SourceShape::Box) {
            const SourceBox box(source);
            at = box.centre();
            for (std::size_t k = 0; k < box.corners().size(); ++k) {
                painter.dashed(box.corners()[k], box.corners()[(k + 1) % 4], fade(colour, 0.8), 1.5);
            }
            if (source.radius > 0.0) {
                const auto corners = box.corners();
                drawReach(painter, {corners.begin(), corners.end()}, source.radius, fade(colour, 0.5));
            }
        } else if (source.radius > 0.0 && source.shape != SourceShape::Line) {
            painter.dashedCircle(source.a, source.radius, fade(colour, 0.8), 1.5);
        }
        painter.dot(at, 3.0, colour);
        painter.ring(at, 6.5, fade(colour, 0.8), 1.25);
        if (labelled) {
            const std::string text = ui::format("%s  \xcf\x81=%.3g", displayName(source, index).c_str(), source.size);
            painter.freeLabel(at, {10.0, -18.0}, text, frame.theme.text, fade(frame.theme.popup, 0.75),
                              frame.fonts.small);
        }
    }

    static void drawNodeSizes(CanvasPainter &painter, const LayerFrame &frame, const Shape &shape, int &drawn) {
        const Box2 visible = frame.camera.visible();
        const std::vector<Vec2> handles = handlesOf(shape);
        for (const auto &[node, part] : shape.nodeSizes) {
            if (node >= handles.size() || !visible.contains(handles[node])) {
                continue;
            }
            painter.ring(handles[node], 6.5, fade(frame.theme.brush, 0.8), 1.25);
            if (drawn++ < kMaxSpacingLabels) {
                painter.freeLabel(handles[node], {10.0, -18.0}, ui::format("\xcf\x81=%.3g", part.size),
                                  frame.theme.text, fade(frame.theme.popup, 0.75), frame.fonts.small);
            }
        }
    }

    static void drawMarker(CanvasPainter &painter, const LayerFrame &frame, const RegionMarker &marker,
                           std::size_t index, bool labelled) {
        painter.dot(marker.at, 3.5, frame.theme.accent);
        painter.ring(marker.at, 6.0, fade(frame.theme.accent, 0.6), 1.25);
        if (!labelled) {
            return;
        }
        const std::string name = regionName(frame.document.regionNames, marker.tag);
        if (painter.freeLabel(
                marker.at, regionLabelOffsets(painter, frame.preview.faces.get(), marker.at, name, frame.fonts.small),
                name, frame.theme.text, fade(frame.theme.popup, 0.75), frame.fonts.small)) {
            painter.nameLabel("label/region/" + std::to_string(index));
        }
    }
};

} // namespace

std::unique_ptr<Layer> makeMarksLayer() {
    return std::make_unique<MarksLayer>();
}

} // namespace forefront
