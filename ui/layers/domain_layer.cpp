#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/gl/gl_kit.hpp"
#include "ui/gl/line_batch.hpp"
#include "ui/layers/layers.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace forefront {

namespace {

class DomainLayer final : public Layer {
  public:
    const char *id() const override { return "domain"; }
    const char *name() const override { return "Domain"; }

    // Identifies the domain of the preview, which may be a little older than the document: a fill that followed every
    // move of the pointer would redraw the mesh with it. The boundary follows every move.
    std::uint64_t stillVersion(const LayerFrame &frame) const override {
        return 4 * frame.preview.revision + (frame.preview.spacing ? 1U : 0U) + (frame.visible("size") ? 2U : 0U);
    }

    void drawStill(const LayerFrame &frame) override {
        if (frame.visible("size") && frame.preview.spacing && frame.raster && !frame.raster->rho.empty()) {
            return; // the colours of the spacing cover all of it
        }
        if (frame.preview.domain) {
            frame.gl.drawField(*frame.preview.domain, frame.preview.revision, frame.camera,
                               frame.area(frame.theme.domain), nullptr);
        }
    }
};

class BoundaryLayer final : public Layer {
  public:
    const char *id() const override { return "boundary"; }
    const char *name() const override { return "Boundary"; }

    void drawLive(const LayerFrame &frame) override {
        update(frame);
        construction_.draw(frame.gl, frame.camera, {.width = 1.0 * frame.scale});
        halo_.draw(frame.gl, frame.camera, {.width = 4.25 * frame.scale});
        constraints_.draw(frame.gl, frame.camera, {.width = 1.75 * frame.scale});
        boundary_.draw(frame.gl, frame.camera, {.width = 2.0 * frame.scale});
        points_.draw(frame.gl, frame.camera, {.width = 6.0 * frame.scale});
    }

  private:
    void update(const LayerFrame &frame) {
        // Curves become polylines finer than the pixels in and around the view; recomputed when the zoom crosses a
        // power of two, and when the view leaves that area. All of a curve would be too much where the zoom is deep.
        const int zoom = frame.domain.curves.empty() ? 0 : std::ilogb(frame.camera.zoom);
        const Box2 visible = frame.camera.visible();
        const bool covered = !partial_ || (detailed_.contains(visible.min) && detailed_.contains(visible.max));
        if (revision_ == frame.revision && theme_ == frame.theme.kind && zoom_ == zoom && covered) {
            return;
        }
        detailed_ = visible.grown(visible.diagonal());
        partial_ = false;
        revision_ = frame.revision;
        theme_ = frame.theme.kind;
        zoom_ = zoom;
        const double tolerance = 0.2 * std::exp2(-zoom);
        boundary_.clear();
        constraints_.clear();
        halo_.clear();
        points_.clear();
        const bool hides = std::any_of(frame.document.shapes.begin(), frame.document.shapes.end(),
                                       [](const auto &shape) { return shape->hidden; });
        const Domain shown = hides ? visiblePart(frame.document) : Domain();
        const Domain &domain = hides ? shown : frame.domain;
        for (const DomainSegment &segment : domain.segments) {
            const bool outer = segment.role == SegmentRole::Boundary;
            const Colour colour = outer ? frame.theme.boundary : frame.theme.constraint;
            Vec2 from = domain.nodes[segment.a];
            for (const Vec2 to : alongSegment(domain, segment, tolerance)) {
                (outer ? boundary_ : constraints_).add(from, to, colour);
                if (!outer) { // colours of values may be as dark or as light as the line
                    halo_.add(from, to, fade(frame.theme.domain, 0.7));
                }
                from = to;
            }
        }
        for (const ConstraintPoint &point : domain.points) {
            points_.add(domain.nodes[point.node], domain.nodes[point.node], frame.theme.constraint);
        }
        updateConstruction(frame);
    }

    /// Adds the outlines of construction geometry, which is no part of the domain.
    void updateConstruction(const LayerFrame &frame) {
        constexpr double kChords = 1e-4; // of the radius
        construction_.clear();
        for (const auto &shape : frame.document.shapes) {
            if (!shape->construction || shape->hidden) {
                continue;
            }
            const Chords chords = chordsOf(*shape, outlineOf(*shape), kChords);
            for (std::size_t k = 0; k < chords.size(); ++k) {
                construction_.add(chords.from(k), chords.to(k), frame.theme.muted);
            }
        }
    }

    /// Returns the domain of the shapes that are not hidden.
    static Domain visiblePart(Document document) {
        std::erase_if(document.shapes, [](const auto &shape) { return shape->hidden; });
        return toDomain(document);
    }

    /// Returns the points of a polyline along a segment, its second end included.
    std::vector<Vec2> alongSegment(const Domain &domain, const DomainSegment &segment, double tolerance) {
        std::vector<Vec2> points;
        const CurveStretch &stretch = segment.stretch;
        if (stretch.curve < domain.curves.size()) {
            const Curve &curve = domain.curves[stretch.curve];
            const std::vector<double> ends = curve.flattenWithin(detailed_, tolerance, stretch.t0, stretch.t1);
            partial_ = partial_ || !detailed_.containsHalfOpen(curve.bounds(stretch.t0, stretch.t1));
            for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
                points.push_back(curve.point(ends[k]));
            }
        }
        points.push_back(domain.nodes[segment.b]);
        return points;
    }

    LineBatch boundary_, constraints_, points_;
    LineBatch construction_;
    LineBatch halo_;       ///< below the constraints
    int zoom_ = 0;         ///< exponent of the zoom that the curves are fine enough for
    Box2 detailed_;        ///< where they are
    bool partial_ = false; ///< curves reach beyond it
    std::uint64_t revision_ = 0;
    ThemeKind theme_ = ThemeKind::Dark;
};

} // namespace

std::unique_ptr<Layer> makeDomainLayer() {
    return std::make_unique<DomainLayer>();
}

std::unique_ptr<Layer> makeBoundaryLayer() {
    return std::make_unique<BoundaryLayer>();
}

} // namespace forefront
