#include "core/drawing/document/document.hpp"
#include "core/drawing/picking/selected_faces.hpp"
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
        const std::set<std::uint32_t> chosen = selectedFaces(*map, frame.document, frame.selection);
        const std::uint32_t pointed = frame.facePlace ? map->faceAt(*frame.facePlace) : kNoIndex;
        if (pointed != kNoIndex && !chosen.contains(pointed)) {
            drawOutlines(painter, frame, *map, {pointed}, fade(frame.theme.selection, 0.6), 1.0);
        }
        drawOutlines(painter, frame, *map, chosen, frame.theme.selection, 2.0);
    }

  private:
    static std::vector<FaceTint> tintsOf(const LayerFrame &frame, const FaceMap &map) {
        const bool values = std::any_of(frame.layers.begin(), frame.layers.end(), [](const LayerSlot &slot) {
            return slot.visible && slot.layer->coloursByValue();
        });
        const double strength = frame.theme.kind == ThemeKind::Dark ? 1.0 : 1.25; // light surfaces swallow tints
        const std::set<std::uint32_t> chosen = selectedFaces(map, frame.document, frame.selection);
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
            tint.fill += strength * ((chosen.contains(face) ? 0.18 : 0.0) + (face == pointed ? 0.1 : 0.0));
        }
        return tints;
    }

    static void drawOutlines(CanvasPainter &painter, const LayerFrame &frame, const FaceMap &map,
                             const std::set<std::uint32_t> &faces, Colour colour, double width) {
        const Box2 visible = frame.camera.visible();
        std::size_t drawn = 0;
        for (const std::uint32_t face : faces) {
            for (const std::uint32_t e : map.edgesOf(face)) {
                const MappedEdge &edge = map.edges()[e];
                if (!boxOf(edge.a, edge.b).grown(edge.deviation).overlaps(visible)) {
                    continue;
                }
                if (edge.deviation > 0.0) {
                    painter.curve(map.curveOf(edge)->part(edge.stretch.t0, edge.stretch.t1), colour, width);
                } else {
                    painter.line(edge.a, edge.b, colour, width);
                }
                if (++drawn >= kMaxOutlineEdges) {
                    return;
                }
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
