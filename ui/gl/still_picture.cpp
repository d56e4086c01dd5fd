#include "ui/gl/still_picture.hpp"

#include <glad/gl.h>

#include <cmath>
#include <utility>

namespace forefront {

namespace {

/// Seconds that the camera must rest before a heavy picture is drawn again.
constexpr double kRest = 0.12;
/// A picture scaled by more than this looks too coarse to show.
constexpr double kMaxScaling = 8.0;

bool sameView(const Camera &a, const Camera &b) {
    return a.centre == b.centre && a.zoom == b.zoom;
}

/// Copies a few pixels to a corner, scaled and cut off, so that the driver prepares both kinds of copies now. Software
/// rendering compiles code for each of them, which took a tenth of a second when a large mesh was first moved.
void prepareCopies(int left, int bottom) {
    constexpr int kPixels = 4;
    glBlitFramebuffer(0, 0, kPixels, kPixels, left, bottom, left + 2 * kPixels, bottom + 2 * kPixels,
                      GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBlitFramebuffer(0, 0, kPixels, kPixels, left - 2, bottom - 2, left + kPixels - 2, bottom + kPixels - 2,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

} // namespace

StillPicture::Target::Target() {
    glGenFramebuffers(1, &framebuffer);
    glGenTextures(1, &texture);
}

StillPicture::Target::~Target() {
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
}

void StillPicture::Target::set(const Camera &camera, bool margin) {
    const PixelRect &view = camera.viewport;
    const double x = margin ? std::floor(view.width / 3.0) : 0.0, y = margin ? std::floor(view.height / 3.0) : 0.0;
    seen = camera;
    wide = camera;
    wide.viewport = {0.0, 0.0, view.width + 2.0 * x, view.height + 2.0 * y};
    const PixelSize needed{static_cast<int>(wide.viewport.width), static_cast<int>(wide.viewport.height)};
    if (needed == size) {
        return;
    }
    size = needed;
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
}

void StillPicture::Target::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.width, size.height);
}

bool StillPicture::Target::resembles(const Camera &camera) const {
    const double scaling = camera.zoom / seen.zoom;
    return scaling < kMaxScaling && scaling > 1.0 / kMaxScaling && camera.visible().overlaps(wide.visible());
}

bool StillPicture::sharp(const PictureContent &content, const Camera &camera) const {
    return drawn_ && content.all == shown().content.all && sameView(camera, shown().seen);
}

bool StillPicture::moves(const PictureContent &content, const Camera &camera, double now, bool heavy) {
    if (!sameView(camera, last_)) {
        movedAt_ = now;
    }
    last_ = camera;
    return heavy && drawn_ && content.all == shown().content.all && shown().resembles(camera) && now - movedAt_ < kRest;
}

Camera StillPicture::begin(const PictureContent &content, const Camera &camera) {
    shown().set(camera, false);
    shown().content = content;
    drawn_ = true;
    refining_ = false;
    shown().bind();
    return shown().wide;
}

Camera StillPicture::refine(const PictureContent &content, const Camera &camera, bool &begins) {
    Target &target = next();
    const bool newContent = !drawn_ || content.all != shown().content.all;
    const bool serves = newContent ? target.resembles(camera) : sameView(camera, target.seen);
    begins =
        !refining_ || content.heavy != target.content.heavy || content.subject != target.content.subject || !serves;
    if (begins) {
        target.set(camera, true);
        target.content = content;
        refining_ = true;
    }
    target.bind();
    return target.wide;
}

void StillPicture::finishRefining() {
    current_ = 1 - current_;
    drawn_ = true;
    refining_ = false;
}

void StillPicture::show(const Camera &camera, Pixel corner) {
    const bool standsIn = drawn_ && shown().content.subject == next().content.subject && shown().resembles(camera);
    const Target &picture = refining_ && !standsIn ? next() : shown();
    const Camera &wide = picture.wide;
    const PixelSize size = picture.size;
    const double scaling = camera.zoom / wide.zoom;
    const Vec2 moved = camera.zoom * (wide.centre - camera.centre); // pixels, y up
    const double middleX = corner.x + std::floor(camera.viewport.width) / 2.0 + moved.x;
    const double middleY = corner.y + std::floor(camera.viewport.height) / 2.0 + moved.y;
    const double halfWidth = 0.5 * scaling * size.width, halfHeight = 0.5 * scaling * size.height;
    const auto pixel = [](double value) { return static_cast<int>(std::lround(value)); };
    glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.framebuffer);
    if (!std::exchange(prepared_, true)) {
        prepareCopies(pixel(corner.x), pixel(corner.y));
    }
    glBlitFramebuffer(0, 0, size.width, size.height, pixel(middleX - halfWidth), pixel(middleY - halfHeight),
                      pixel(middleX + halfWidth), pixel(middleY + halfHeight), GL_COLOR_BUFFER_BIT,
                      scaling == 1.0 ? GL_NEAREST : GL_LINEAR);
}

} // namespace forefront
