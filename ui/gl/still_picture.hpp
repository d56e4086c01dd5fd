#pragma once

#include "ui/canvas/camera.hpp"
#include "ui/platform/platform.hpp"

#include <cstdint>

namespace forefront {

/// A texture that caches the still parts of the canvas between frames. While the camera moves, it can be shifted and
/// scaled instead of being drawn again.
class StillPicture {
  public:
    StillPicture();
    ~StillPicture();
    StillPicture(const StillPicture &) = delete;
    StillPicture &operator=(const StillPicture &) = delete;

    /// Returns true if the picture shows this content exactly as seen by this camera.
    bool sharp(std::uint64_t content, const Camera &camera) const;
    /// Returns true if the picture should be moved rather than drawn again: it shows this content, the content is
    /// `heavy`, and the camera has only just moved. `now`: seconds.
    bool moves(std::uint64_t content, const Camera &camera, double now, bool heavy);
    /// Makes the texture the render target and returns the camera to draw with. A heavy picture extends beyond the
    /// view, so that it can be moved.
    Camera begin(std::uint64_t content, const Camera &camera, bool heavy);
    /// Copies the picture to the current framebuffer, as seen by this camera. `corner`: lower left corner of the canvas
    /// in that framebuffer.
    void show(const Camera &camera, Pixel corner) const;

  private:
    void resize(PixelSize size);

    unsigned framebuffer_ = 0, texture_ = 0;
    PixelSize size_;
    bool drawn_ = false;
    std::uint64_t content_ = 0;
    Camera seen_;           ///< the view that the picture was drawn for
    Camera wide_;           ///< the same with the margin around it
    Camera last_;           ///< of the last frame
    double movedAt_ = -1e9; ///< when the camera last moved, seconds
};

} // namespace forefront
