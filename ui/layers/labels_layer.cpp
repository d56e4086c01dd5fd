#include "core/drawing/shapes/tag_runs.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/layers/layers.hpp"
#include "ui/style/imgui_versions.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace forefront {

namespace {

class LabelsLayer final : public Layer {
  public:
    const char *id() const override { return "labels"; }
    const char *name() const override { return "Labels"; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        if (revision_ != frame.revision) {
            revision_ = frame.revision;
            updateRuns(frame.document);
        }
        if (!frame.document.boundaryNames.empty()) {
            reserveOutlines(painter, frame);
        }
        for (const RunsOfShape &runs : runs_) {
            for (std::size_t k = 0; k < runs.runs.size(); ++k) {
                if (drawName(painter, frame, runs.runs[k])) {
                    painter.nameLabel("label/boundary/" + std::to_string(runs.shape->id) + '/' + std::to_string(k));
                }
            }
        }
    }

  private:
    /// Segments of a shape with the same tag, one after the other, and the place of their name. It is beside the run,
    /// but not at its middle, where the arrow of the front is.
    struct Run {
        std::int32_t tag = 0;
        Vec2 at;
        Vec2 along;          ///< unit vector of the outline there
        double extent = 0.0; ///< length; of a circle, its diameter
    };
    struct RunsOfShape {
        std::shared_ptr<const Shape> shape;
        Outline outline;
        std::vector<Run> runs;
    };

    /// Keeps labels off the boundary. Of very many segments, most are too short for a name beside them.
    void reserveOutlines(CanvasPainter &painter, const LayerFrame &frame) const {
        constexpr std::size_t kMaxSegments = 2000;
        const Box2 visible = frame.camera.visible();
        std::size_t segments = 0;
        for (const RunsOfShape &runs : runs_) {
            if (runs.shape->hidden || runs.runs.empty()) {
                continue;
            }
            segments += runs.outline.segmentCount();
            if (segments > kMaxSegments) {
                return;
            }
            if (boundsOf(*runs.shape).overlaps(visible)) {
                painter.reserve(runs.outline);
            }
        }
    }

    /// Finds the runs of shapes that have changed; a dragged node changes one shape of many.
    void updateRuns(const Document &document) {
        runs_.resize(document.shapes.size());
        for (std::size_t k = 0; k < runs_.size(); ++k) {
            if (runs_[k].shape != document.shapes[k]) {
                const Shape &shape = *document.shapes[k];
                runs_[k] = {document.shapes[k], outlineOf(shape), shape.hidden ? std::vector<Run>() : runsOf(shape)};
            }
        }
    }

    static std::vector<Run> runsOf(const Shape &shape) {
        if (shape.is<CircleForm>() && shape.nodes.size() >= 2) {
            const double radius = distance(shape.nodes[0], shape.nodes[1]);
            return {{shape.tag, shape.nodes[0] + Vec2{0.0, radius}, {1.0, 0.0}, 2.0 * radius}};
        }
        const Outline outline = outlineOf(shape);
        const std::size_t segments = outline.segmentCount();
        std::vector<double> lengths;
        for (std::size_t i = 0; i < segments; ++i) {
            lengths.push_back(outline.curve(i).length());
        }
        std::vector<Run> runs;
        for (const TagRun &run : tagRuns(shape, outline)) {
            double whole = 0.0;
            for (std::size_t k = 0; k < run.count; ++k) {
                whole += lengths[run.segment(k, segments)];
            }
            double way = 0.3 * whole;
            std::size_t at = run.first;
            for (std::size_t k = 0; k + 1 < run.count && way > lengths[at]; ++k) {
                way -= lengths[at];
                at = at + 1 < segments ? at + 1 : 0;
            }
            const Curve curve = outline.curve(at);
            // On a cubic, this is a point near that place.
            const double t = lengths[at] > 0.0 ? std::min(1.0, way / lengths[at]) : 0.0;
            runs.push_back({run.tag, curve.point(t), curve.tangent(t), whole});
        }
        return runs;
    }

    /// Writes a name beside its run, with a leader to it. Returns false if there is no room: a name covers no outline,
    /// so no hole either, and little of the drawing.
    static bool drawName(CanvasPainter &painter, const LayerFrame &frame, const Run &run) {
        const auto named = frame.document.boundaryNames.find(run.tag);
        if (named == frame.document.boundaryNames.end() || frame.camera.zoom * run.extent < 40.0 * frame.scale ||
            !frame.camera.visible().contains(run.at)) {
            return false;
        }
        const std::string &name = named->second;
        ImFont &font = *frame.fonts.small;
        const ImVec2 size = font.CalcTextSizeA(imgui::lineOf(font), 1e9F, 0.0F, name.data(), name.data() + name.size());
        const Pixel half = 0.5 / frame.scale * Pixel(size.x, size.y);
        const Pixel side{run.along.y, run.along.x}; // across the run, on the screen
        constexpr double kGap = 12.0;
        const double reach = std::abs(side.x) * half.x + std::abs(side.y) * half.y + kGap;
        std::vector<Pixel> offsets;
        for (const double away : {reach, -reach, reach + 2.0 * half.y, -reach - 2.0 * half.y}) {
            offsets.push_back(away * side - half);
        }
        constexpr double kLargestPart = 0.08; // of the drawing
        const Vec2 drawing = frame.camera.zoom / frame.scale * frame.domain.bounds().size();
        if (4.0 * half.x * half.y > kLargestPart * drawing.x * drawing.y ||
            !painter.freeLabel(run.at, offsets, name, frame.theme.muted, labelPlate(frame.theme), frame.fonts.small)) {
            return false;
        }
        painter.leader(run.at, frame.theme.muted);
        return true;
    }

    std::vector<RunsOfShape> runs_; ///< of the document with revision_
    std::uint64_t revision_ = ~std::uint64_t{0};
};

} // namespace

std::unique_ptr<Layer> makeLabelsLayer() {
    return std::make_unique<LabelsLayer>();
}

} // namespace forefront
