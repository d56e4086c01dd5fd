#include "core/engine/base/hash.hpp"
#include "core/engine/mesh/placed_cell.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/canvas/legend.hpp"
#include "ui/gl/gl_kit.hpp"
#include "ui/gl/mesh_batch.hpp"
#include "ui/layers/layers.hpp"
#include "ui/style/measure_colours.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/mesh/mesh_judge.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// Opacity, relative to that of single edges, of edges too dense to be told apart. They then cover as much as the edges
/// of triangles 8 pixels wide, so that a finer part never looks emptier than a coarser one.
constexpr double kDenseEdges = 0.45;
/// The same over colours of values, which would lose their hue under more.
constexpr double kDenseOnValues = 0.25;
/// Maximum number of labels; more would hide the elements.
constexpr std::size_t kMaxAlphaLabels = 60;

/// No value is below or above these.
constexpr double kNoMinimum = -1e30, kNoMaximum = 1e38;

bool coloursByAlpha(const LayerFrame &frame) {
    return frame.judgement.of.measure == Measure::ShapeFactor;
}

/// Returns the mesh to draw. While values of a newer mesh are being computed, the colours are shown on the mesh that
/// they belong to; α is computed with the mesh.
const std::shared_ptr<const MeshSnapshot> &meshShown(const LayerFrame &frame) {
    if (frame.gliding && !(frame.visible("quality") && !coloursByAlpha(frame))) {
        return frame.gliding;
    }
    const bool earlier =
        frame.visible("quality") && !coloursByAlpha(frame) && frame.snapshot.mesh && frame.judgement.of.mesh;
    return earlier ? frame.judgement.of.mesh : frame.snapshot.mesh;
}

std::size_t countOf(const std::shared_ptr<const MeshSnapshot> &mesh) {
    return mesh ? mesh->mesh.elements.size() : 0;
}

/// Returns true if the values of the elements can be seen: as colours, or because those of a bin are shown alone.
bool showsValues(const LayerFrame &frame) {
    return frame.visible("quality") || frame.isolatedBin;
}

/// Returns the version of the mesh and of the values that colour it. Values that are not shown do not count: those of
/// a live mesh arrive after it.
std::uint64_t shapeOf(const LayerFrame &frame) {
    const std::shared_ptr<const MeshSnapshot> &mesh = meshShown(frame);
    Hash64 hash;
    hash.add(mesh ? mesh->version : 0);
    hash.add(frame.snapshot.run);
    if (!showsValues(frame)) {
        return hash.value();
    }
    hash.add(static_cast<std::uint64_t>(frame.judgement.of.measure));
    hash.add(reinterpret_cast<std::uintptr_t>(frame.judgement.of.spacing.get()));
    hash.add(static_cast<std::uint64_t>(frame.judgement.values.size()));
    hash.add(reinterpret_cast<std::uintptr_t>(frame.judgement.of.fieldValues.get()));
    return hash.value();
}

std::uint64_t versionOf(const LayerFrame &frame) {
    Hash64 hash;
    hash.add(shapeOf(frame));
    if (showsValues(frame)) {
        hash.add(static_cast<std::uint64_t>(frame.isolatedBin ? *frame.isolatedBin + 1 : 0));
        hash.add(frame.measureRange.from);
        hash.add(frame.measureRange.to);
        hash.add(reinterpret_cast<std::uintptr_t>(frame.measureMap));
        hash.add(frame.measureBounds.minimum.value_or(kNoMinimum));
        hash.add(frame.measureBounds.maximum.value_or(kNoMaximum));
    }
    return hash.value();
}

bool atRest(const SessionSnapshot &snapshot) {
    return snapshot.state == RunState::Finished || snapshot.state == RunState::Cancelled;
}

/// Returns the values that colour the mesh; they view the judgement.
MeshValues valuesOf(const LayerFrame &frame) {
    const Judgement &judgement = frame.judgement;
    const MeasureInfo &info = judgement.info;
    Hash64 version;
    version.add(judgement.of.mesh ? judgement.of.mesh->version : 0);
    version.add(static_cast<std::uint64_t>(judgement.of.measure));
    version.add(reinterpret_cast<std::uintptr_t>(judgement.of.spacing.get()));
    version.add(static_cast<std::uint64_t>(judgement.values.size()));
    version.add(reinterpret_cast<std::uintptr_t>(judgement.of.fieldValues.get()));
    return {.part = info.part,
            .values = judgement.values,
            .edges = judgement.edges.get(),
            .smooth = judgement.of.fieldValues && info.part == MeshPart::Nodes,
            .logarithmic = info.logarithmic,
            .version = version.value()};
}

/// Draws faces and edges in one pass, for both layers: the quality layer gives the faces their colours, the mesh layer
/// adds the edges. They share a batch, since only one of them draws.
void drawElements(const LayerFrame &frame, bool edges) {
    MeshBatch &batch = frame.gl.elements();
    const bool quality = frame.visible("quality");
    const bool tinted = frame.visible("size");
    // Bars of the histogram isolate parts by their values, also when the faces are not coloured.
    const bool valued = !coloursByAlpha(frame) && showsValues(frame) && meshShown(frame) == frame.judgement.of.mesh;
    const MeshValues values = valuesOf(frame);
    batch.update(meshShown(frame), atRest(frame.snapshot), valued ? &values : nullptr);
    MeshStyle style;
    style.face = tinted ? Colour() : frame.area(frame.theme.element);
    style.edge = !edges ? Colour() : tinted ? frame.theme.meshOnTint : frame.theme.mesh;
    style.edgeWidth = 1.0 * frame.scale;
    style.denseEdges = quality ? kDenseOnValues : kDenseEdges;
    style.map = quality ? frame.measureMap : nullptr;
    style.cyclic = frame.judgement.of.measure == Measure::Region;
    style.range = frame.measureRange;
    if (quality) {
        style.badBelow = frame.measureBounds.minimum.value_or(kNoMinimum);
        style.badAbove = frame.measureBounds.maximum.value_or(kNoMaximum);
    }
    style.hatch = fade(frame.theme.boundary, 0.8);
    const MeasureHistogram &bins = frame.judgement.histogram;
    if (frame.isolatedBin && (valued || coloursByAlpha(frame)) &&
        static_cast<std::size_t>(*frame.isolatedBin) < bins.bins.size()) {
        // The bins at the ends also hold the values outside.
        const auto bin = static_cast<std::size_t>(*frame.isolatedBin);
        const double lowest = bins.logarithmic ? 1e-30 : -8e29;
        style.isolateFrom = bin == 0 ? lowest : bins.edge(bin);
        style.isolateTo = bin + 1 == bins.bins.size() ? 1e38 : bins.edge(bin + 1);
    }
    batch.draw(frame.gl, frame.camera, style, frame.slice);
}

class MeshLayer final : public Layer {
  public:
    const char *id() const override { return "mesh"; }
    const char *name() const override { return "Mesh"; }
    void request(SnapshotLayers &layers) const override { layers.mesh = true; }

    std::uint64_t stillVersion(const LayerFrame &frame) const override { return versionOf(frame); }
    std::uint64_t stillShape(const LayerFrame &frame) const override { return shapeOf(frame); }
    std::size_t stillElements(const LayerFrame &frame) const override { return countOf(meshShown(frame)); }
    void drawStill(const LayerFrame &frame) override { drawElements(frame, true); }
};

class QualityLayer final : public Layer {
  public:
    const char *id() const override { return "quality"; }
    const char *name() const override { return "Quality"; }
    bool coloursByValue() const override { return true; }
    void request(SnapshotLayers &layers) const override { layers.mesh = true; }

    std::uint64_t stillVersion(const LayerFrame &frame) const override { return versionOf(frame); }
    std::uint64_t stillShape(const LayerFrame &frame) const override { return shapeOf(frame); }
    std::size_t stillElements(const LayerFrame &frame) const override { return countOf(meshShown(frame)); }

    void drawStill(const LayerFrame &frame) override {
        if (!frame.visible("mesh")) {
            drawElements(frame, false);
        }
    }

    /// Writes α on bad elements that are large enough for it.
    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        if (!frame.snapshot.mesh || !coloursByAlpha(frame)) {
            return;
        }
        findBad(*frame.snapshot.mesh, frame.measureBounds.minimum.value_or(kNoMinimum));
        const MeshView mesh = frame.snapshot.mesh->view();
        const Box2 visible = frame.camera.visible();
        std::size_t shown = 0;
        for (const std::size_t i : bad_) {
            const PlacedCell cell(mesh, i);
            const Vec2 middle = cell.centre();
            if (!visible.contains(middle) ||
                frame.camera.zoom * distance(cell.nodes[0], cell.nodes[1]) < 24.0 * frame.scale) {
                continue;
            }
            painter.freeLabel(middle, {-12, -7}, ui::format("%.2f", static_cast<double>(frame.snapshot.mesh->alpha[i])),
                              frame.theme.bad, labelPlate(frame.theme), frame.fonts.small);
            if (++shown >= kMaxAlphaLabels) {
                break;
            }
        }
    }

    bool hasLegend() const override { return true; }
    bool drawLegend(CanvasPainter &painter, const LayerFrame &frame, Pixel corner) override {
        const Measure measure = frame.judgement.of.measure;
        const MeasureInfo &info = frame.judgement.info;
        if (frame.judgement.summary.count == 0) {
            return false;
        }
        std::string title = frame.judgement.name;
        if (measure == Measure::ShapeFactor) {
            title = "shape factor \xce\xb1";
        } else if (*info.unit != '\0') {
            title += std::string(", ") + info.unit;
        }
        drawColourBar(painter, frame.theme, frame.fonts, corner,
                      {.title = title, .map = frame.measureMap, .ticks = ticks(frame), .limit = limitOn(frame)});
        return true;
    }

  private:
    /// Returns the place of the limit on the bar.
    static std::optional<LegendLimit> limitOn(const LayerFrame &frame) {
        const Measure measure = frame.judgement.of.measure;
        const std::optional<MeshLimit> limit = limitOf(measure);
        if (!limit || frame.judgement.of.fieldValues) {
            return std::nullopt;
        }
        return LegendLimit{limitPosition(measure, frame.measureRange, frame.measureBounds),
                           limitInfo(*limit).isMinimum};
    }

    static std::vector<LegendTick> ticks(const LayerFrame &frame) {
        const Measure measure = frame.judgement.of.measure;
        const ColourRange &range = frame.measureRange;
        if (measure == Measure::Region) {
            std::vector<LegendTick> tags;
            for (int tag = 1; tag <= 8; ++tag) {
                tags.push_back({mapPosition(measure, range, tag), std::to_string(tag)});
            }
            return tags;
        }
        return infoOf(measure).logarithmic ? logarithmicTicks(range.from, range.to, 5) : linearTicks(range);
    }

    void findBad(const MeshSnapshot &view, double limit) {
        if (view.version == version_ && limit == limit_) {
            return;
        }
        version_ = view.version;
        limit_ = limit;
        bad_.clear();
        for (std::size_t i = 0; i < view.alpha.size(); ++i) {
            if (static_cast<double>(view.alpha[i]) < limit) {
                bad_.push_back(i);
            }
        }
    }

    std::vector<std::size_t> bad_;
    std::uint64_t version_ = ~std::uint64_t{0};
    double limit_ = 0.0; ///< of α in `bad_`
};

} // namespace

std::unique_ptr<Layer> makeMeshLayer() {
    return std::make_unique<MeshLayer>();
}

std::unique_ptr<Layer> makeQualityLayer() {
    return std::make_unique<QualityLayer>();
}

} // namespace forefront
