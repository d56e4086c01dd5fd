#include "core/drawing/names/part_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/layers/layers.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

namespace {

/// Draws what ties or divides edges: cracks as two lines, periodic parts with a line between them, and the regions that
/// are filled by rows, with their corners.
class LinksLayer final : public Layer {
  public:
    const char *id() const override { return "links"; }
    const char *name() const override { return "Linked edges"; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        update(frame);
        const double away = 2.5 * frame.scale / frame.camera.zoom;
        for (const Curve &curve : cracks_) {
            drawCrack(painter, frame, curve, away);
        }
        for (std::size_t k = 0; k < frame.document.periodic.size(); ++k) {
            drawPair(painter, frame, frame.document.periodic[k], k);
        }
        for (const MarkedRegion &marker : frame.document.regionMarkers) {
            if (isMapped(frame.document, marker.tag)) {
                painter.freeLabel(marker.at, Pixel(10.0, 10.0), "rows", frame.theme.muted,
                                  fade(frame.theme.popup, 0.82), frame.fonts.small);
            }
        }
        for (const MappedSpec &spec : frame.document.mapped) {
            drawCorners(painter, frame, spec);
        }
    }

  private:
    void update(const LayerFrame &frame) {
        if (revision_ == frame.revision) {
            return;
        }
        revision_ = frame.revision;
        cracks_.clear();
        middles_.clear();
        const Document &document = frame.document;
        if (document.cracks.empty() && document.periodic.empty()) {
            return;
        }
        for (const auto &shape : document.shapes) {
            if (shape->hidden || shape->construction) {
                continue;
            }
            const Outline outline = outlineOf(*shape);
            for (std::size_t k = 0; k < outline.segmentCount(); ++k) {
                const std::int32_t tag = segmentTag(*shape, static_cast<std::uint32_t>(outline.part(k)));
                if (shape->use == ShapeUse::Constraint && isCrack(document, tag)) {
                    cracks_.push_back(outline.curve(k));
                }
                if (periodicPartner(document, tag)) {
                    middles_[tag].push_back(outline.curve(k).point(0.5));
                }
            }
        }
    }

    /// Draws the two sides of a crack beside its line.
    static void drawCrack(CanvasPainter &painter, const LayerFrame &frame, const Curve &curve, double away) {
        constexpr int kPieces = 24;
        const int pieces = curve.kind() == CurveKind::Line ? 1 : kPieces;
        for (const double side : {away, -away}) {
            std::vector<Vec2> points;
            for (int i = 0; i <= pieces; ++i) {
                const double t = static_cast<double>(i) / pieces;
                const Vec2 along = curve.tangent(t);
                points.push_back(curve.point(t) + side * Vec2{-along.y, along.x});
            }
            painter.polyline(points, false, frame.theme.constraint, 1.5);
        }
    }

    /// Draws the corners of the faces of a mapped region with their numbers; given ones that no face has, as faults.
    static void drawCorners(CanvasPainter &painter, const LayerFrame &frame, const MappedSpec &spec) {
        constexpr double kHalfSide = 4.0; // design pixels
        const auto outlines = frame.preview.mapped.find(spec.region);
        if (frame.preview.revision != frame.revision || outlines == frame.preview.mapped.end()) {
            return; // the corners follow with the preview
        }
        bool all = true;
        for (const MappedOutline &outline : outlines->second) {
            all = all && !outline.corners.empty();
            for (std::size_t k = 0; k < outline.corners.size(); ++k) {
                const Vec2 at = outline.nodes[outline.corners[k]];
                painter.handle(at, kHalfSide, frame.theme.constraint, frame.theme.canvas);
                painter.freeLabel(at, Pixel(9.0, -9.0), std::to_string(k + 1), frame.theme.muted,
                                  fade(frame.theme.popup, 0.82), frame.fonts.small);
            }
        }
        for (std::size_t k = 0; k < spec.corners.size() && !all; ++k) {
            painter.handle(spec.corners[k], kHalfSide, frame.theme.bad, frame.theme.canvas);
        }
    }

    /// Draws a line between the middles of two parts, with the same number at both.
    void drawPair(CanvasPainter &painter, const LayerFrame &frame, const PeriodicSpec &pair, std::size_t number) const {
        const auto from = middles_.find(pair.from), to = middles_.find(pair.to);
        if (from == middles_.end() || to == middles_.end()) {
            return;
        }
        const Vec2 a = from->second[from->second.size() / 2], b = to->second[to->second.size() / 2];
        painter.dashed(a, b, fade(frame.theme.constraint, 0.6), 1.0, 8.0);
        const std::string text = "periodic " + std::to_string(number + 1);
        for (const Vec2 at : {a, b}) {
            painter.freeLabel(at, Pixel(8.0, 8.0), text, frame.theme.muted, fade(frame.theme.popup, 0.82),
                              frame.fonts.small);
        }
    }

    std::uint64_t revision_ = 0;
    std::vector<Curve> cracks_;                         ///< of the document with revision_
    std::map<std::int32_t, std::vector<Vec2>> middles_; ///< of the segments of periodic parts, by tag
};

} // namespace

std::unique_ptr<Layer> makeLinksLayer() {
    return std::make_unique<LinksLayer>();
}

} // namespace forefront
