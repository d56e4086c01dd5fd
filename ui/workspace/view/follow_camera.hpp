#pragma once

#include "core/engine/session/snapshot.hpp"
#include "ui/workspace/view/view.hpp"

namespace forefront {

/// Returns the box that shows an advance: its base, candidates, elements and search circle.
Box2 boxOf(const AdvanceExplanation &advance);

/// The camera that follows the front. It keeps still while the advance is well in view, and then moves smoothly to a
/// new place, so that neighbouring advances do not shake the picture.
class FollowCamera {
  public:
    /// Moves the view towards a box for `seconds` of time. Returns true while it has further to go.
    bool follow(View &view, const Box2 &box, double seconds);
    /// Forgets the target, so that the next box becomes the target at once.
    void reset() { target_ = {}; }

  private:
    /// Returns true if the box is inside the middle of the target and not too small in it.
    bool serves(const Box2 &box, const View &view) const;

    Box2 target_; ///< shown in the middle of the free room; empty: none yet
};

} // namespace forefront
