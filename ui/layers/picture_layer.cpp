#include "core/drawing/document/document.hpp"
#include "core/engine/base/hash.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/gl/picture_texture.hpp"
#include "ui/layers/layers.hpp"

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
            for (const double number :
                 {picture->corner.x, picture->corner.y, picture->size.x, picture->size.y, picture->opacity}) {
                hash.add(number);
            }
        }
        return hash.value();
    }

    void drawStill(const LayerFrame &frame) override {
        texture_.update(frame.picture);
        if (frame.document.picture) {
            texture_.draw(frame.camera, boundsOf(*frame.document.picture), frame.document.picture->opacity);
        }
    }

    void drawOverlay(CanvasPainter &painter, const LayerFrame &frame) override {
        const std::optional<BackgroundPicture> &picture = frame.document.picture;
        if (!picture || !frame.pictureFailed) {
            return;
        }
        const Box2 box = boundsOf(*picture);
        painter.rectangle(box, frame.theme.warn, 1.5);
        painter.line(box.min, box.max, fade(frame.theme.warn, 0.4), 1.0);
        painter.line({box.min.x, box.max.y}, {box.max.x, box.min.y}, fade(frame.theme.warn, 0.4), 1.0);
        painter.text(box.centre(), std::filesystem::path(picture->file).filename().string() + " cannot be read",
                     frame.theme.warn);
    }

  private:
    PictureTexture texture_;
};

} // namespace

std::unique_ptr<Layer> makePictureLayer() {
    return std::make_unique<PictureLayer>();
}

} // namespace forefront
