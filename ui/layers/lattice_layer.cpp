#include "core/drawing/picking/pointer_snap.hpp"
#include "core/engine/base/hash.hpp"
#include "ui/canvas/line_density.hpp"
#include "ui/canvas/ruler_scale.hpp"
#include "ui/gl/gl_kit.hpp"
#include "ui/gl/line_batch.hpp"
#include "ui/layers/layers.hpp"

#include <cmath>

namespace forefront {

namespace {

class LatticeLayer final : public Layer {
  public:
    const char *id() const override { return "lattice"; }
    const char *name() const override { return "Grid"; }

    std::uint64_t stillVersion(const LayerFrame &frame) const override {
        Hash64 hash;
        hash.add(frame.gridStep);
        return hash.value();
    }

    void drawStill(const LayerFrame &frame) override {
        const double pitch = steppedPitch(frame.gridStep, frame.camera.length(frame.scale));
        const Box2 visible = frame.camera.visible();
        lines_.clear();
        const auto colour = [&](double i) {
            return std::fmod(i, 5.0) == 0.0 ? fade(frame.theme.gridLine, 2.0) : frame.theme.gridLine;
        };
        const Multiples columns = multiplesWithin(visible.min.x, visible.max.x, pitch);
        for (int k = 0; k < columns.count; ++k) {
            const double i = columns.first + k;
            lines_.add({i * pitch, visible.min.y}, {i * pitch, visible.max.y}, colour(i));
        }
        const Multiples rows = multiplesWithin(visible.min.y, visible.max.y, pitch);
        for (int k = 0; k < rows.count; ++k) {
            const double i = rows.first + k;
            lines_.add({visible.min.x, i * pitch}, {visible.max.x, i * pitch}, colour(i));
        }
        lines_.draw(frame.gl, frame.camera, {.width = densityWidth(frame.camera.zoom * pitch, 1.0 * frame.scale)});
    }

  private:
    LineBatch lines_;
};

} // namespace

std::unique_ptr<Layer> makeLatticeLayer() {
    return std::make_unique<LatticeLayer>();
}

} // namespace forefront
