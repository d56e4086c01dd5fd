#include "ui/gl/still_picture.hpp"

#include <glad/gl.h>

#include <cmath>

namespace forefront {

namespace {

/// Seconds that the camera must rest before a heavy picture is drawn again.
constexpr double kRest = 0.12;
/// A picture scaled by more than this looks too coarse to show.
constexpr double kMaxScaling = 8.0;

} // namespace

StillPicture::StillPicture() {
    glGenFramebuffers(1, &framebuffer_);
    glGenTextures(1, &texture_);
}

StillPicture::~StillPicture() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &texture_);
}

void StillPicture::resize(PixelSize size) {
    if (size == size_) {
        return;
    }
    size_ = size;
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
}

bool StillPicture::sharp(std::uint64_t content, const Camera &camera) const {
    return drawn_ && content == content_ && camera.centre == seen_.centre && camera.zoom == seen_.zoom;
}

bool StillPicture::moves(std::uint64_t content, const Camera &camera, double now, bool heavy) {
    if (!(camera.centre == last_.centre && camera.zoom == last_.zoom)) {
        movedAt_ = now;
    }
    last_ = camera;
    const double scaling = camera.zoom / seen_.zoom;
    const bool useful =
        scaling < kMaxScaling && scaling > 1.0 / kMaxScaling && camera.visible().overlaps(wide_.visible());
    return heavy && drawn_ && content == content_ && useful && now - movedAt_ < kRest;
}

Camera StillPicture::begin(std::uint64_t content, const Camera &camera, bool heavy) {
    const PixelRect &view = camera.viewport;
    const double x = heavy ? std::floor(view.width / 3.0) : 0.0, y = heavy ? std::floor(view.height / 3.0) : 0.0;
    wide_ = camera;
    wide_.viewport = {0.0, 0.0, view.width + 2.0 * x, view.height + 2.0 * y};
    seen_ = camera;
    content_ = content;
    drawn_ = true;
    const PixelSize size{static_cast<int>(wide_.viewport.width), static_cast<int>(wide_.viewport.height)};
    resize(size);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, size.width, size.height);
    return wide_;
}

void StillPicture::show(const Camera &camera, Pixel corner) const {
    const double scaling = camera.zoom / wide_.zoom;
    const Vec2 moved = camera.zoom * (wide_.centre - camera.centre); // pixels, y up
    const double middleX = corner.x + std::floor(camera.viewport.width) / 2.0 + moved.x;
    const double middleY = corner.y + std::floor(camera.viewport.height) / 2.0 + moved.y;
    const double halfWidth = 0.5 * scaling * size_.width, halfHeight = 0.5 * scaling * size_.height;
    const auto pixel = [](double value) { return static_cast<int>(std::lround(value)); };
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glBlitFramebuffer(0, 0, size_.width, size_.height, pixel(middleX - halfWidth), pixel(middleY - halfHeight),
                      pixel(middleX + halfWidth), pixel(middleY + halfHeight), GL_COLOR_BUFFER_BIT,
                      scaling == 1.0 ? GL_NEAREST : GL_LINEAR);
}

} // namespace forefront
