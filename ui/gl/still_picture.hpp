#pragma once

#include "ui/canvas/camera.hpp"
#include "ui/platform/platform.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace forefront {

/// A texture that caches the still parts of the canvas between frames. While the camera moves, it can be shifted and
/// scaled instead of being drawn again. A second texture takes the next picture if that is drawn over several frames.
class StillPicture {
  public:
    /// Returns true if the picture shows this content exactly as seen by this camera.
    bool sharp(std::uint64_t content, const Camera &camera) const;
    /// Returns true if the picture should be moved rather than drawn again: it shows this content, the content is
    /// `heavy`, and the camera has only just moved. `now`: seconds.
    bool moves(std::uint64_t content, const Camera &camera, double now, bool heavy);
    /// Makes the texture the render target and returns the camera to draw with. A heavy picture extends beyond the
    /// view, so that it can be moved.
    Camera begin(std::uint64_t content, const Camera &camera, bool heavy);

    /// Returns true if the picture can be shown while it is drawn again for this camera over several frames: it shows
    /// this content, seen from a similar place.
    bool canRefine(std::uint64_t content, const Camera &camera) const;
    /// Begins or continues a heavy picture of the same content for another camera. Makes the second texture the render
    /// target and returns the camera to draw with; `begins` is set if nothing has been drawn for it yet.
    Camera refine(const Camera &camera, bool &begins);
    /// Shows the picture that refine() was called for, once it is complete.
    void finishRefining();
    /// Copies the picture to the current framebuffer, as seen by this camera. `corner`: lower left corner of the canvas
    /// in that framebuffer.
    void show(const Camera &camera, Pixel corner) const;

  private:
    /// A texture and the view that it was drawn for.
    struct Target {
        unsigned framebuffer = 0, texture = 0;
        PixelSize size;
        Camera seen; ///< the view
        Camera wide; ///< the same with the margin around it

        Target();
        ~Target();
        Target(const Target &) = delete;
        Target &operator=(const Target &) = delete;
        /// Sets the view and resizes the texture for it.
        void set(const Camera &camera, bool margin);
        void bind() const;
    };
    Target &shown() { return targets_[current_]; }
    const Target &shown() const { return targets_[current_]; }
    /// Returns true if the picture, moved and scaled, resembles what a camera sees.
    bool resembles(const Camera &camera) const;

    std::array<Target, 2> targets_;
    std::size_t current_ = 0;
    bool drawn_ = false;
    bool refining_ = false; ///< the other target is being drawn
    std::uint64_t content_ = 0;
    Camera last_;           ///< of the last frame
    double movedAt_ = -1e9; ///< when the camera last moved, seconds
};

} // namespace forefront
