#include "core/drawing/document/document.hpp"
#include "core/drawing/shapes/references.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/gl/face_fill.hpp"
#include "ui/layers/layers.hpp"
#include "ui/style/measure_colours.hpp"

#include <algorithm>
#include <set>
#include <vector>

namespace forefront {

namespace {

/// Maximum number of edges drawn along the outlines of highlighted faces; more would take too long.
constexpr std::size_t kMaxOutlineEdges = 4000;
constexpr double kRimWidth = 14.0; ///< design pixels

/// Tints the faces that belong to regions. Where other colours show values, only a rim inside each face has the colour
/// of its region, so that the values keep theirs.
class RegionsLayer final : public Layer {
  public:
    const char *id() const override { return "regions"; }
    const char *name() const override { return "Regions"; }

    void drawLive(const LayerFrame &frame) override {
        const std::shared_ptr<const FaceMap> &map = frame.preview.faces;
        if (!map || map->faces().empty()) {
            return;
        }
        const std::vector<FaceTint> tints = tintsOf(frame, *map);
        if (std::any_of(tints.begin(), tints.end(), [](const FaceTint &tint) { return tint.visible(); })) {
            fill_.draw(map, tints, frame.camera, frame.scale, kRimWidth);
        }
    }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        const std::shared_ptr<const FaceMap> &map = frame.preview.faces;
        if (!map) {
            return;
        }
        std::set<std::uint32_t> outlined = selectedFaces(frame, *map);
        const std::uint32_t pointed = frame.facePlace ? map->faceAt(*frame.facePlace) : kNoIndex;
        if (pointed != kNoIndex) {
            outlined.insert(pointed);
        }
        if (!outlined.empty()) {
            drawOutlines(painter, frame, *map, outlined);
        }
    }

  private:
    static std::set<std::uint32_t> selectedFaces(const LayerFrame &frame, const FaceMap &map) {
        std::set<std::uint32_t> faces;
        for (const std::uint32_t k : frame.selection.markers) {
            if (k < frame.document.regionMarkers.size()) {
                faces.insert(map.faceOf(frame.document.regionMarkers[k]));
            }
        }
        faces.erase(kNoIndex);
        return faces;
    }

    static std::vector<FaceTint> tintsOf(const LayerFrame &frame, const FaceMap &map) {
        const bool values = std::any_of(frame.layers.begin(), frame.layers.end(), [](const LayerSlot &slot) {
            return slot.visible && slot.layer->coloursByValue();
        });
        const double strength = frame.theme.kind == ThemeKind::Dark ? 1.0 : 1.25; // light surfaces swallow tints
        const std::set<std::uint32_t> chosen = selectedFaces(frame, map);
        const std::uint32_t pointed = frame.facePlace ? map.faceAt(*frame.facePlace) : kNoIndex;
        std::vector<FaceTint> tints(map.faces().size());
        for (std::uint32_t face = 0; face < tints.size(); ++face) {
            const MappedFace &what = map.faces()[face];
            const bool named = what.marker != kNoIndex;
            FaceTint &tint = tints[face];
            tint.colour = named ? regionColour(what.tag) : frame.theme.accent;
            if (named) {
                tint.fill = strength * (values ? 0.0 : 0.14);
                tint.rim = strength * (values ? 0.5 : 0.3);
            }
            if (face == pointed || chosen.contains(face)) {
                tint.fill += strength * (face == pointed ? 0.16 : 0.1);
            }
        }
        return tints;
    }

    static void drawOutlines(CanvasPainter &painter, const LayerFrame &frame, const FaceMap &map,
                             const std::set<std::uint32_t> &faces) {
        const Box2 visible = frame.camera.visible();
        std::size_t drawn = 0;
        for (const MappedEdge &edge : map.edges()) {
            if (!faces.contains(edge.left) && !faces.contains(edge.right)) {
                continue;
            }
            if (!boxOf(edge.a, edge.b).grown(edge.deviation).overlaps(visible)) {
                continue;
            }
            if (edge.deviation > 0.0) {
                painter.curve(map.curveOf(edge)->part(edge.stretch.t0, edge.stretch.t1), frame.theme.selection, 2.0);
            } else {
                painter.line(edge.a, edge.b, frame.theme.selection, 2.0);
            }
            if (++drawn >= kMaxOutlineEdges) {
                return;
            }
        }
    }

    FaceFill fill_;
};

} // namespace

std::unique_ptr<Layer> makeRegionsLayer() {
    return std::make_unique<RegionsLayer>();
}

} // namespace forefront
