#include "core/drawing/document/document.hpp"
#include "core/drawing/formulas/spacing_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/spacing/spec/source_box.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/canvas/label_offsets.hpp"
#include "ui/canvas/region_label.hpp"
#include "ui/layers/layers.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// Maximum number of marks drawn in view, and of labels; more would be clutter.
constexpr std::size_t kMaxSpacingMarks = 600;
constexpr std::size_t kMaxSpacingLabels = 40;
constexpr double kMarkRing = 6.5; ///< radius, design pixels
constexpr double kMarkGap = 16.0; ///< between markers with rings, design pixels

/// Draws size sources, sizes at nodes and region markers.
class MarksLayer final : public Layer {
  public:
    const char *id() const override { return "marks"; }
    const char *name() const override { return "Marks"; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        const Box2 visible = frame.camera.visible();
        const std::vector<SizeSource> &sources = frame.document.spacing.sources;
        const std::vector<MarkedRegion> &markers = frame.document.regionMarkers;
        std::vector<std::size_t> seenSources, seenMarkers;
        for (std::size_t k = 0; k < sources.size() && seenSources.size() < kMaxSpacingMarks; ++k) {
            if (boxOfSource(sources[k]).overlaps(visible)) {
                seenSources.push_back(k);
                drawSource(painter, frame, sources[k]);
            }
        }
        for (std::size_t k = 0; k < markers.size() && seenMarkers.size() < kMaxSpacingMarks; ++k) {
            if (visible.contains(markers[k].at)) {
                seenMarkers.push_back(k);
            }
        }
        const bool crowded = areCrowded(frame, seenMarkers);
        for (const std::size_t k : seenMarkers) {
            drawMarker(painter, frame, markers[k], crowded);
        }
        // All marks come first, so that none is drawn across the label of another one.
        const std::vector<OutlineLine> outlines =
            seenSources.empty() ? std::vector<OutlineLine>() : outlinesIn(frame, visible);
        for (std::size_t k = 0; k < std::min(seenSources.size(), kMaxSpacingLabels); ++k) {
            labelSource(painter, frame, outlines, seenSources[k]);
        }
        std::size_t drawn = 0;
        for (const auto &shape : frame.document.shapes) {
            if (!shape->nodeSizes.empty() && !shape->hidden && drawn < kMaxSpacingMarks) {
                drawNodeSizes(painter, frame, *shape, drawn);
            }
            if (!shape->segmentSizes.empty() && !shape->hidden && drawn < kMaxSpacingMarks) {
                drawSegmentSizes(painter, frame, *shape, drawn);
            }
        }
        for (std::size_t k = 0; k < std::min(seenMarkers.size(), kMaxSpacingLabels); ++k) {
            labelMarker(painter, frame, seenMarkers[k]);
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

    /// Returns the place of the mark and the label of a source.
    static Vec2 placeOf(const SizeSource &source) {
        return source.shape == SourceShape::Box ? SourceBox(source).centre() : source.a;
    }

    /// Draws a source and keeps labels off its mark and its line.
    static void drawSource(CanvasPainter &painter, const LayerFrame &frame, const SizeSource &source) {
        const Colour colour = frame.theme.brush;
        if (source.shape == SourceShape::Line) {
            painter.line(source.a, source.b, fade(colour, 0.8), 2.0);
            painter.reserveLine(source.a, source.b);
            painter.dot(source.b, 3.0, colour);
            if (source.radius > 0.0) {
                drawReach(painter, {source.a, source.b}, source.radius, fade(colour, 0.5));
            }
            if (source.endSize) {
                painter.ring(source.b, kMarkRing, fade(colour, 0.8), 1.25);
                painter.reserve(source.b, kMarkRing);
            }
        }
        if (source.shape == SourceShape::Box) {
            const SourceBox box(source);
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
        const Vec2 at = placeOf(source);
        painter.dot(at, 3.0, colour);
        painter.ring(at, kMarkRing, fade(colour, 0.8), 1.25);
        painter.reserve(at, kMarkRing);
    }

    /// A piece of an outline, in pixels.
    using OutlineLine = std::pair<Pixel, Pixel>;

    /// Returns the outlines in view. Of very many, a label cannot keep clear.
    static std::vector<OutlineLine> outlinesIn(const LayerFrame &frame, const Box2 &visible) {
        constexpr std::size_t kMaxOutlineLines = 4000;
        constexpr int kPiecesOfCurve = 8;
        std::vector<OutlineLine> lines;
        for (const auto &shape : frame.document.shapes) {
            if (shape->hidden || !boundsOf(*shape).overlaps(visible)) {
                continue;
            }
            const Outline outline = outlineOf(*shape);
            for (std::size_t k = 0; k < outline.segmentCount() && lines.size() < kMaxOutlineLines; ++k) {
                const Curve curve = outline.curve(k);
                const int pieces = curve.kind() == CurveKind::Line ? 1 : kPiecesOfCurve;
                for (int i = 0; i < pieces; ++i) {
                    lines.emplace_back(frame.camera.toPixel(curve.point(static_cast<double>(i) / pieces)),
                                       frame.camera.toPixel(curve.point(static_cast<double>(i + 1) / pieces)));
                }
            }
        }
        return lines;
    }

    static void labelSource(CanvasPainter &painter, const LayerFrame &frame, const std::vector<OutlineLine> &outlines,
                            std::size_t index) {
        const SizeSource &source = frame.document.spacing.sources[index];
        const std::string text = ui::format("%s  \xcf\x81=%.3g", displayName(source, index).c_str(), source.size);
        writeBeside(painter, frame, outlines, placeOf(source), text);
        if (source.shape == SourceShape::Line && source.endSize) {
            writeBeside(painter, frame, outlines, source.b, ui::format("\xcf\x81=%.3g", *source.endSize));
        }
    }

    /// Writes a text beside a mark, on the usual side or wherever there is room: off the outlines if it can be.
    static void writeBeside(CanvasPainter &painter, const LayerFrame &frame, const std::vector<OutlineLine> &outlines,
                            Vec2 at, const std::string &text) {
        ImFont *const font = frame.fonts.small;
        const Pixel size = painter.labelSize(text, font);
        std::vector<Pixel> offsets = offsetsBeside(size, {10.0, -18.0});
        const std::vector<Pixel> farther = offsetsBeside(size, {26.0, -18.0});
        offsets.insert(offsets.end(), farther.begin(), farther.end());
        std::stable_partition(offsets.begin(), offsets.end(), [&](Pixel offset) {
            const PixelRect rect = painter.labelRect(at, offset, text, font);
            return std::none_of(outlines.begin(), outlines.end(),
                                [&rect](const OutlineLine &line) { return meets(rect, line.first, line.second); });
        });
        painter.freeLabel(at, offsets, text, frame.theme.text, labelPlate(frame.theme), font);
    }

    static void drawNodeSizes(CanvasPainter &painter, const LayerFrame &frame, const Shape &shape, std::size_t &drawn) {
        const Box2 visible = frame.camera.visible();
        const std::vector<Vec2> handles = handlesOf(shape);
        for (const auto &[node, part] : shape.nodeSizes) {
            if (node >= handles.size() || !visible.contains(handles[node])) {
                continue;
            }
            painter.ring(handles[node], 6.5, fade(frame.theme.brush, 0.8), 1.25);
            if (drawn++ < kMaxSpacingLabels) {
                painter.freeLabel(handles[node], {10.0, -18.0}, ui::format("\xcf\x81=%.3g", part.size),
                                  frame.theme.text, labelPlate(frame.theme), frame.fonts.small);
            }
        }
    }

    /// Writes the size or the number of elements at the middle of each segment that has one of its own.
    static void drawSegmentSizes(CanvasPainter &painter, const LayerFrame &frame, const Shape &shape,
                                 std::size_t &drawn) {
        const Box2 visible = frame.camera.visible();
        const Outline outline = outlineOf(shape);
        std::set<std::uint32_t> seen; // of the pieces of a part, the first one
        for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
            const auto own = shape.segmentSizes.find(outline.part(k));
            if (own == shape.segmentSizes.end() || !seen.insert(outline.part(k)).second) {
                continue;
            }
            const Vec2 middle = outline.curve(k).point(0.5);
            if (!visible.contains(middle)) {
                continue;
            }
            painter.dot(middle, 3.0, fade(frame.theme.brush, 0.8));
            if (drawn++ < kMaxSpacingLabels) {
                const SegmentSize &size = own->second;
                const std::string text = size.elements > 0 ? std::to_string(size.elements) + " elements"
                                                           : ui::format("\xcf\x81=%.3g", size.size);
                painter.freeLabel(middle, {10.0, -18.0}, text, frame.theme.text, labelPlate(frame.theme),
                                  frame.fonts.small);
            }
        }
    }

    /// Returns true if rings around the markers would cover much of the drawing, as on a map of many towns.
    static bool areCrowded(const LayerFrame &frame, const std::vector<std::size_t> &seen) {
        const double gap = frame.camera.length(kMarkGap * frame.scale);
        std::vector<Vec2> apart;
        for (const std::size_t k : seen) {
            const Vec2 at = frame.document.regionMarkers[k].at;
            if (std::none_of(apart.begin(), apart.end(), [&](Vec2 other) { return distance(at, other) < gap; })) {
                apart.push_back(at);
            }
        }
        return 3 * apart.size() < 2 * seen.size();
    }

    static void drawMarker(CanvasPainter &painter, const LayerFrame &frame, const MarkedRegion &marker, bool crowded) {
        const double size = crowded ? 0.5 : 1.0;
        // A plate, since the colours below may be those of the marker.
        painter.dot(marker.at, 8.0 * size, labelPlate(frame.theme));
        painter.dot(marker.at, 3.5 * size, frame.theme.accent);
        if (!crowded) {
            painter.ring(marker.at, kMarkRing, frame.theme.accent, 1.25);
        }
        painter.reserve(marker.at, kMarkRing * size);
    }

    static void labelMarker(CanvasPainter &painter, const LayerFrame &frame, std::size_t index) {
        const MarkedRegion &marker = frame.document.regionMarkers[index];
        const std::string name = regionName(frame.document.regionNames, marker.tag);
        if (painter.freeLabel(
                marker.at, regionLabelOffsets(painter, frame.preview.faces.get(), marker.at, name, frame.fonts.small),
                name, frame.theme.text, labelPlate(frame.theme), frame.fonts.small)) {
            painter.nameLabel("label/region/" + std::to_string(index));
        }
    }
};

} // namespace

std::unique_ptr<Layer> makeMarksLayer() {
    return std::make_unique<MarksLayer>();
}

} // namespace forefront
