#include "core/edit/shape_geometry.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/layers/layers.hpp"
#include "ui/workspace/moment.hpp"

#include <algorithm>
#include <string>

namespace forefront {

namespace {

constexpr std::size_t kMaxIds = 80;

class LabelsLayer final : public Layer {
  public:
    const char *id() const override { return "labels"; }
    const char *name() const override { return "Labels"; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        drawNodeNumbers(painter, frame);
        for (const auto &shape : frame.document.shapes) {
            drawNames(painter, frame, *shape);
        }
    }

  private:
    /// Writes the name of each run of segments with the same tag beside the run, but not at its middle, where the arrow
    /// of the front is.
    static void drawNames(CanvasPainter &painter, const LayerFrame &frame, const Shape &shape) {
        if (shape.kind == ShapeKind::Circle && shape.nodes.size() >= 2) {
            const double radius = distance(shape.nodes[0], shape.nodes[1]);
            drawName(painter, frame, shape.nodes[0] + Vec2{0.0, radius}, shape.tag, 2.0 * radius);
            return;
        }
        const Outline outline = outlineOf(shape);
        const std::size_t segments = outline.segmentCount();
        if (segments == 0) {
            return;
        }
        const auto tagOf = [&](std::size_t i) { return segmentTag(shape, outline.part(i)); };
        std::size_t begin = 0; // a run of a closed outline may go on over its first node
        while (outline.closed && begin < segments && tagOf(begin) == tagOf((begin + segments - 1) % segments)) {
            ++begin;
        }
        for (std::size_t first = begin % segments, seen = 0; seen < segments;) {
            std::size_t count = 0;
            double whole = 0.0;
            while (seen < segments && tagOf((first + count) % segments) == tagOf(first)) {
                whole += outline.curve((first + count) % segments).length();
                ++count;
                ++seen;
            }
            drawName(painter, frame, pointAlong(outline, first, count, 0.3 * whole), tagOf(first), whole);
            first = (first + count) % segments;
        }
    }

    /// Returns the point at a length along `count` segments of the outline, the first of which is `first`; on a cubic,
    /// a point near it.
    static Vec2 pointAlong(const Outline &outline, std::size_t first, std::size_t count, double way) {
        std::size_t i = first;
        for (std::size_t k = 0; k + 1 < count; ++k) {
            const Curve curve = outline.curve(i);
            const double length = curve.length();
            if (way <= length) {
                return curve.point(length > 0.0 ? way / length : 0.0);
            }
            way -= length;
            i = i + 1 < outline.segmentCount() ? i + 1 : 0;
        }
        const Curve last = outline.curve(i);
        const double length = last.length();
        return last.point(length > 0.0 ? std::min(1.0, way / length) : 0.0);
    }

    static void drawName(CanvasPainter &painter, const LayerFrame &frame, Vec2 at, std::int32_t tag, double extent) {
        const auto named = frame.document.boundaryNames.find(tag);
        if (named == frame.document.boundaryNames.end() || frame.camera.zoom * extent < 40.0 * frame.scale) {
            return;
        }
        const double half = 3.25 * static_cast<double>(named->second.size());
        painter.freeLabel(at, {-half, -7.0}, named->second, frame.theme.muted, fade(frame.theme.popup, 0.82),
                          frame.fonts.small);
    }

    static void drawNodeNumbers(CanvasPainter &painter, const LayerFrame &frame) {
        if (!frame.snapshot.mesh || frame.snapshot.mesh->mesh.nodes.empty()) {
            return;
        }
        const std::vector<Vec2> &nodes = frame.snapshot.mesh->mesh.nodes;
        const Box2 visible = frame.camera.visible();
        const Vec2 all = frame.domain.bounds().size(), seen = visible.size();
        const double part = std::min(1.0, seen.x * seen.y / std::max(all.x * all.y, 1e-300));
        if (part * static_cast<double>(nodes.size()) > 40.0 * static_cast<double>(kMaxIds)) {
            return;
        }
        std::vector<std::size_t> inView;
        for (std::size_t i = 0; i < nodes.size() && inView.size() <= kMaxIds; ++i) {
            if (visible.contains(nodes[i])) {
                inView.push_back(i);
            }
        }
        if (inView.size() > kMaxIds) {
            return;
        }
        const Moment moment = momentOf(frame.snapshot);
        for (const std::size_t i : inView) {
            if (namedElsewhere(moment, i)) {
                continue;
            }
            painter.dot(nodes[i], 2.0, frame.theme.muted);
            painter.freeLabel(nodes[i], {6, 3}, std::to_string(i), frame.theme.muted, fade(frame.theme.popup, 0.2),
                              frame.fonts.small);
        }
    }

    /// Returns true for A, B and the candidates, which have separate labels.
    static bool namedElsewhere(const Moment &moment, std::size_t node) {
        if (!moment) {
            return false;
        }
        const AdvanceExplanation &e = *moment.advance;
        const auto is = [node](NodeId id) { return id != kNoNode && index(id) == node; };
        return is(e.nodeA) || is(e.nodeB) ||
               std::any_of(e.candidates.begin(), e.candidates.end(),
                           [&](const CandidateTrace &c) { return is(c.node); });
    }
};

} // namespace

std::unique_ptr<Layer> makeLabelsLayer() {
    return std::make_unique<LabelsLayer>();
}

} // namespace forefront
