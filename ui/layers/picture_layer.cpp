#include "core/drawing/document/document.hpp"
#include "core/engine/base/hash.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/gl/picture_texture.hpp"
#include "ui/layers/layers.hpp"

#include <array>
#include <cstdint>
#include <filesystem>

namespace forefront {

namespace {

/// Draws the background picture of the document below everything else; a frame with its name if it cannot be read.
class PictureLayer final : public Layer {
  public:
    const char *id() const override { return "picture"; }
    const char *name() const override { return "Picture"; }

    std::uint64_t stillVersion(const LayerFrame &frame) const override {
        const std::optional<BackgroundPicture> &picture = frame.document.picture;
        Hash64 hash;
        hash.add(reinterpret_cast<std::uintptr_t>(frame.picture.get()));
        if (picture) {
            for (const double number : {picture->corner.x, picture->corner.y, picture->size.x, picture->size.y,
                                        picture->opacity, picture->angle}) {
                hash.add(number);
            }
        }
        return hash.value();
    }

    void drawStill(const LayerFrame &frame) override {
        texture_.update(frame.picture);
        if (frame.document.picture) {
            const BackgroundPicture &picture = *frame.document.picture;
            texture_.draw(frame.camera, {lowerEdge(picture), leftEdge(picture), picture.corner}, picture.opacity);
        }
    }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        const std::optional<BackgroundPicture> &picture = frame.document.picture;
        if (!picture || !frame.pictureFailed) {
            return;
        }
        const std::array<Vec2, 4> corners = cornersOf(*picture);
        painter.polyline(corners, true, frame.theme.warn, 1.5);
        painter.line(corners[0], corners[2], fade(frame.theme.warn, 0.4), 1.0);
        painter.line(corners[1], corners[3], fade(frame.theme.warn, 0.4), 1.0);
        painter.text(midpoint(corners[0], corners[2]),
                     std::filesystem::path(picture->file).filename().string() + " cannot be read", frame.theme.warn);
    }

  private:
    PictureTexture texture_;
};

} // namespace

std::unique_ptr<Layer> makePictureLayer() {
    return std::make_unique<PictureLayer>();
}

} // namespace forefront
