#include "core/base/hash.hpp"
#include "core/mesh/quality.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/canvas/legend.hpp"
#include "ui/gl/gl_kit.hpp"
#include "ui/gl/mesh_batch.hpp"
#include "ui/layers/layers.hpp"
#include "ui/style/colour_map.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// Elements with α below this are hatched and numbered.
constexpr double kBad = 0.5;
/// Maximum number of labels; more would hide the elements.
constexpr std::size_t kMaxNumbers = 60;
/// Edges on opaque colours: dark in both themes, since the colours are the same in both.
constexpr Colour kEdgeOnColour = rgb(0x0b1018, 0.6);

std::uint64_t versionOf(const LayerFrame &frame) {
    const std::uint64_t mesh = frame.snapshot.mesh ? frame.snapshot.mesh->version : 0;
    const auto bin = static_cast<std::uint64_t>(frame.isolatedBin ? *frame.isolatedBin + 1 : 0);
    Hash64 hash;
    hash.add(mesh);
    hash.add(frame.snapshot.run);
    hash.add(bin);
    hash.add(frame.qualityRange.from);
    hash.add(frame.qualityRange.to);
    return hash.value();
}

bool atRest(const SessionSnapshot &snapshot) {
    return snapshot.state == RunState::Finished || snapshot.state == RunState::Cancelled;
}

/// Draws faces and edges in one pass, for both layers: the quality layer gives the faces their colours, the mesh layer
/// adds the edges.
class ElementPainter {
  public:
    void draw(const LayerFrame &frame, bool edges) {
        batch_.update(frame.snapshot.mesh, atRest(frame.snapshot));
        const bool quality = frame.visible("quality");
        const bool tinted = frame.visible("size");
        MeshStyle style;
        style.face = tinted ? Colour() : frame.theme.element;
        style.edge = !edges ? Colour() : quality || tinted ? kEdgeOnColour : frame.theme.mesh;
        style.edgeWidth = 1.0 * frame.scale;
        style.denseEdges = tinted ? 0.2 : 0.0; // shows what is meshed while the front advances
        style.coloured = quality;
        style.range = frame.qualityRange;
        style.badBelow = quality ? kBad : -2.0;
        style.hatch = frame.theme.bad;
        if (frame.isolatedBin) {
            const double bins = static_cast<double>(kHistogramBins);
            style.isolateFrom = *frame.isolatedBin == 0 ? -2.0 : *frame.isolatedBin / bins;
            style.isolateTo =
                *frame.isolatedBin + 1 == static_cast<int>(kHistogramBins) ? 2.0 : (*frame.isolatedBin + 1) / bins;
        }
        batch_.draw(frame.gl, frame.camera, style);
    }

  private:
    MeshBatch batch_;
};

class MeshLayer final : public Layer {
  public:
    const char *id() const override { return "mesh"; }
    const char *name() const override { return "Mesh"; }
    void request(SnapshotLayers &layers) const override { layers.mesh = true; }

    std::uint64_t stillVersion(const LayerFrame &frame) const override { return versionOf(frame); }
    void drawStill(const LayerFrame &frame) override { painter_.draw(frame, true); }

  private:
    ElementPainter painter_;
};

class QualityLayer final : public Layer {
  public:
    const char *id() const override { return "quality"; }
    const char *name() const override { return "Quality \xce\xb1"; }
    bool visibleAtStart() const override { return false; }
    bool coloursByValue() const override { return true; }
    void request(SnapshotLayers &layers) const override { layers.mesh = true; }

    std::uint64_t stillVersion(const LayerFrame &frame) const override { return versionOf(frame); }

    void drawStill(const LayerFrame &frame) override {
        if (!frame.visible("mesh")) {
            painter_.draw(frame, false);
        }
    }

    /// Writes α on bad elements that are large enough for it.
    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        if (!frame.snapshot.mesh) {
            return;
        }
        findBad(*frame.snapshot.mesh);
        const Mesh &mesh = frame.snapshot.mesh->mesh;
        const Box2 visible = frame.camera.visible();
        std::size_t shown = 0;
        for (const std::size_t i : bad_) {
            const Element &e = mesh.elements[i];
            const Vec2 a = mesh.nodes[index(e[0])], b = mesh.nodes[index(e[1])], c = mesh.nodes[index(e[2])];
            const Vec2 middle = (1.0 / 3.0) * (a + b + c);
            if (!visible.contains(middle) || frame.camera.zoom * distance(a, b) < 24.0 * frame.scale) {
                continue;
            }
            painter.freeLabel(middle, {-12, -7}, ui::format("%.2f", static_cast<double>(frame.snapshot.mesh->alpha[i])),
                              frame.theme.bad, fade(frame.theme.popup, 0.9), frame.fonts.small);
            if (++shown >= kMaxNumbers) {
                break;
            }
        }
    }

    bool hasLegend() const override { return true; }
    bool drawLegend(CanvasPainter &painter, const LayerFrame &frame, Pixel corner) override {
        drawColourBar(painter, frame.theme, frame.fonts, corner, "shape factor \xce\xb1  (hatched: below 0.5)", cividis,
                      linearTicks(frame.qualityRange), std::clamp(frame.qualityRange.position(kBad), 0.0, 1.0));
        return true;
    }

  private:
    void findBad(const MeshView &view) {
        if (view.version == version_) {
            return;
        }
        version_ = view.version;
        bad_.clear();
        for (std::size_t i = 0; i < view.alpha.size() && i < view.mesh.elements.size(); ++i) {
            if (static_cast<double>(view.alpha[i]) < kBad) {
                bad_.push_back(i);
            }
        }
    }

    ElementPainter painter_;
    std::vector<std::size_t> bad_;
    std::uint64_t version_ = ~std::uint64_t{0};
};

} // namespace

std::unique_ptr<Layer> makeMeshLayer() {
    return std::make_unique<MeshLayer>();
}

std::unique_ptr<Layer> makeQualityLayer() {
    return std::make_unique<QualityLayer>();
}

} // namespace forefront
