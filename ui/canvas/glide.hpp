#pragma once

#include "ui/canvas/camera.hpp"

#include <cstdint>

namespace forefront {

/// Moves the picture smoothly when the camera jumps to a target: it takes 120 ms and slows down at the end. The camera
/// itself is at its target at once, so that clicks and commands never wait.
class Glide {
  public:
    /// Returns the camera to draw with at `now`, in seconds. `jumps` counts the jumps of the camera; other moves are
    /// shown at once. Without `smooth`, jumps are as well.
    Camera next(const Camera &target, std::uint64_t jumps, double now, bool smooth);
    /// Returns true while the picture has further to go.
    bool moving() const { return moving_; }

  private:
    Camera from_, shown_;
    std::uint64_t jumps_ = 0;
    double begin_ = -1e300;
    bool moving_ = false;
};

} // namespace forefront
