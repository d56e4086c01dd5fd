#pragma once

#include "ui/canvas/camera.hpp"
#include "ui/platform/platform.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace forefront {

/// The content of a picture, as numbers that change with it, but not with the camera.
struct PictureContent {
    std::uint64_t all = 0;     ///< everything
    std::uint64_t heavy = 0;   ///< the parts that take long to draw, without their style
    std::uint64_t subject = 0; ///< pictures of another subject are not shown while the next one is being drawn
};

/// A texture that caches the still parts of the canvas between frames. While the camera moves, it can be shifted and
/// scaled instead of being drawn again. A second texture takes the next picture if that is drawn over several frames.
class StillPicture {
  public:
    /// Returns true if the picture shows this content exactly as seen by this camera.
    bool sharp(const PictureContent &content, const Camera &camera) const;
    /// Returns true if the picture should be moved rather than drawn again: it shows this content, the content is
    /// `heavy`, and the camera has only just moved. `now`: seconds.
    bool moves(const PictureContent &content, const Camera &camera, double now, bool heavy);
    /// Makes the texture the render target and returns the camera to draw with, for a picture drawn in one frame.
    Camera begin(const PictureContent &content, const Camera &camera);

    /// Begins or continues a heavy picture, which is drawn over several frames. Makes the second texture the render
    /// target and returns the camera to draw with; `begins` is set if nothing has been drawn for it yet. The picture
    /// extends beyond the view, so that it can be moved. A change of light parts does not begin it again, or a drag
    /// could keep it from being completed; nor does a move of the camera if it shows new content.
    Camera refine(const PictureContent &content, const Camera &camera, bool &begins);
    /// Shows the picture that refine() was called for, once it is complete.
    void finishRefining();
    /// Gives up a heavy picture that is incomplete.
    void abandon() { refining_ = false; }
    /// Returns true while a heavy picture of new content is incomplete.
    bool pictureIncomplete() const { return refining_ && !(drawn_ && next().content.all == shown().content.all); }
    /// Copies the last complete picture to the current framebuffer, as seen by this camera. If it shows something else,
    /// copies the finished part of the next picture instead. `corner`: lower left corner of the canvas in that
    /// framebuffer.
    void show(const Camera &camera, Pixel corner);

  private:
    /// A texture and the view that it was drawn for.
    struct Target {
        unsigned framebuffer = 0, texture = 0;
        PixelSize size;
        Camera seen; ///< the view
        Camera wide; ///< the same with the margin around it
        PictureContent content;

        Target();
        ~Target();
        Target(const Target &) = delete;
        Target &operator=(const Target &) = delete;
        /// Sets the view and resizes the texture for it.
        void set(const Camera &camera, bool margin);
        void bind() const;
        /// Returns true if the picture, moved and scaled, resembles what a camera sees.
        bool resembles(const Camera &camera) const;
    };
    Target &shown() { return targets_[current_]; }
    const Target &shown() const { return targets_[current_]; }
    Target &next() { return targets_[1 - current_]; }
    const Target &next() const { return targets_[1 - current_]; }

    std::array<Target, 2> targets_;
    bool prepared_ = false; ///< see prepareCopies()
    std::size_t current_ = 0;
    bool drawn_ = false;    ///< the current target holds a complete picture
    bool refining_ = false; ///< the other target is being drawn
    Camera last_;           ///< of the last frame
    double movedAt_ = -1e9; ///< when the camera last moved, seconds
};

} // namespace forefront
