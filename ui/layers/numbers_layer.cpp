#include "core/engine/mesh/placed_cell.hpp"
#include "core/teaching/moment/moment.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/layers/layers.hpp"
#include "ui/style/imgui_versions.hpp"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

namespace forefront {

namespace {

/// Maximum number of nodes and of elements that are numbered; more could not be read.
constexpr std::size_t kMaxNumbers = 80;

/// Returns true for A, B and the candidates, which have separate labels.
bool namedByStep(const Moment &moment, std::size_t node) {
    if (!moment) {
        return false;
    }
    const AdvanceExplanation &e = *moment.advance;
    const auto is = [node](NodeId id) { return id != kNoNode && index(id) == node; };
    return is(e.nodeA) || is(e.nodeB) ||
           std::any_of(e.candidates.begin(), e.candidates.end(), [&](const CandidateTrace &c) { return is(c.node); });
}

/// Returns the numbers of the places in a box; nothing if there are more than kMaxNumbers. `placeAt`: of a number.
template <class PlaceAt>
std::vector<std::size_t> numbersIn(const Box2 &box, std::size_t count, PlaceAt placeAt) {
    std::vector<std::size_t> inside;
    for (std::size_t k = 0; k < count && inside.size() <= kMaxNumbers; ++k) {
        if (box.contains(placeAt(k))) {
            inside.push_back(k);
        }
    }
    return inside.size() > kMaxNumbers ? std::vector<std::size_t>() : inside;
}

class NumbersLayer final : public Layer {
  public:
    const char *id() const override { return "numbers"; }
    const char *name() const override { return "Numbers"; }
    void request(SnapshotLayers &layers) const override { layers.mesh = true; }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        if (!frame.snapshot.mesh || frame.snapshot.mesh->mesh.nodes.empty()) {
            return;
        }
        const MeshView mesh = frame.snapshot.mesh->view();
        // Looking at all of a large mesh in each frame would be slow, and show nothing.
        constexpr double kMaxExpected = 40.0 * static_cast<double>(kMaxNumbers);
        const Vec2 all = frame.domain.bounds().size(), seen = frame.camera.visible().size();
        const double part = std::min(1.0, seen.x * seen.y / std::max(all.x * all.y, 1e-300));
        if (part * static_cast<double>(mesh.nodes.size()) > kMaxExpected) {
            return;
        }
        drawNodes(painter, frame, mesh);
        drawElements(painter, frame, mesh);
    }

  private:
    static void drawNodes(CanvasPainter &painter, const LayerFrame &frame, const MeshView &mesh) {
        const Moment moment = momentOf(frame.snapshot);
        for (const std::size_t k :
             numbersIn(frame.camera.visible(), mesh.nodes.size(), [&](std::size_t node) { return mesh.nodes[node]; })) {
            if (namedByStep(moment, k)) {
                continue;
            }
            painter.dot(mesh.nodes[k], 2.0, frame.theme.muted);
            painter.freeLabel(mesh.nodes[k], {6, 3}, std::to_string(k), frame.theme.text, labelPlate(frame.theme),
                              frame.fonts.small);
        }
    }

    /// Numbers elements in their middle, where they are large enough.
    static void drawElements(CanvasPainter &painter, const LayerFrame &frame, const MeshView &mesh) {
        constexpr double kSmallest = 44.0; // side of an element, in design pixels
        const auto middle = [&](std::size_t element) { return PlacedCell(mesh, element).centre(); };
        for (const std::size_t k : numbersIn(frame.camera.visible(), mesh.elementCount(), middle)) {
            const PlacedCell cell(mesh, k);
            if (frame.camera.zoom * distance(cell.nodes[0], cell.nodes[1]) < kSmallest * frame.scale) {
                continue;
            }
            const std::string number = std::to_string(k);
            ImFont &font = *frame.fonts.small;
            const ImVec2 size = font.CalcTextSizeA(imgui::lineOf(font), 1e9F, 0.0F, number.c_str());
            const Pixel half = 0.5 / frame.scale * Pixel(size.x, size.y);
            painter.freeLabel(cell.centre(), Pixel{-half.x, -half.y}, number, frame.theme.muted, Colour(),
                              frame.fonts.small);
        }
    }
};

} // namespace

std::unique_ptr<Layer> makeNumbersLayer() {
    return std::make_unique<NumbersLayer>();
}

} // namespace forefront
