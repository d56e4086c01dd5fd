#pragma once

#include "core/engine/session/snapshot.hpp"
#include "ui/workspace/view/view.hpp"

#include <optional>

namespace forefront {

/// Returns the box that shows an advance: its base, candidates, elements and search circle.
Box2 boxOf(const AdvanceExplanation &advance);

/// The camera that follows the front. It keeps still while the advance is well in view, and then moves smoothly to a
/// new place, so that neighbouring advances do not shake the picture.
class FollowCamera {
  public:
    /// What the camera shows: the box of an advance, and the length of its base AB.
    struct Subject {
        Box2 box;
        double base = 0.0;
    };

    /// Moves the view towards a subject for `seconds` of time. The base is then 60 to 120 design pixels long, each of
    /// `scale` pixels. Returns true while it has further to go.
    bool follow(View &view, const Subject &subject, double seconds, double scale);
    /// Forgets the target, so that the next box becomes the target at once.
    void reset() { target_ = {}; }

  private:
    double zoomOf(const View &view, double scale) const;
    /// Returns true if the subject is inside the middle of the target and its base neither too short nor too long.
    bool serves(const Subject &subject, const View &view, double scale) const;

    Subject target_; ///< shown in the middle of the free room; an empty box: none yet
};

/// Returns what there is to follow at a position of a run: the advance, or the place that a step of the improvement
/// changed. None: nothing, or the step moves nodes all over the mesh.
std::optional<FollowCamera::Subject> subjectOf(const SessionSnapshot &run);

} // namespace forefront
