#include "ui/canvas/canvas_painter.hpp"
#include "ui/gl/gl_kit.hpp"
#include "ui/gl/line_batch.hpp"
#include "ui/layers/layers.hpp"

namespace forefront {

namespace {

class DomainLayer final : public Layer {
  public:
    const char *id() const override { return "domain"; }
    const char *name() const override { return "Domain"; }

    std::uint64_t stillVersion(const LayerFrame &frame) const override {
        return 4 * frame.revision + (frame.preview.spacing ? 1U : 0U) + (frame.visible("size") ? 2U : 0U);
    }

    void drawStill(const LayerFrame &frame) override {
        if (frame.visible("size") && frame.preview.spacing && frame.raster && !frame.raster->rho.empty()) {
            return; // the colours of the spacing cover all of it
        }
        frame.gl.drawField(frame.domain, frame.revision, frame.camera, frame.theme.domain, nullptr);
    }
};

class BoundaryLayer final : public Layer {
  public:
    const char *id() const override { return "boundary"; }
    const char *name() const override { return "Boundary"; }

    void drawLive(const LayerFrame &frame) override {
        update(frame);
        constraints_.draw(frame.gl, frame.camera, {.width = 1.75 * frame.scale});
        boundary_.draw(frame.gl, frame.camera, {.width = 2.25 * frame.scale});
        points_.draw(frame.gl, frame.camera, {.width = 6.0 * frame.scale});
    }

  private:
    void update(const LayerFrame &frame) {
        if (revision_ == frame.revision && theme_ == frame.theme.kind) {
            return;
        }
        revision_ = frame.revision;
        theme_ = frame.theme.kind;
        boundary_.clear();
        constraints_.clear();
        points_.clear();
        const Domain &domain = frame.domain;
        for (const DomainSegment &segment : domain.segments) {
            const bool outer = segment.role == SegmentRole::Boundary;
            (outer ? boundary_ : constraints_)
                .add(domain.nodes[segment.a], domain.nodes[segment.b],
                     outer ? frame.theme.boundary : frame.theme.constraint);
        }
        for (const ConstraintPoint &point : domain.points) {
            points_.add(domain.nodes[point.node], domain.nodes[point.node], frame.theme.constraint);
        }
    }

    LineBatch boundary_, constraints_, points_;
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
