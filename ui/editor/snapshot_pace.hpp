#pragma once

#include <algorithm>

namespace forefront {

/// Limits how often snapshots of a working run are drawn, so that two thirds of the time are left for user input
/// however large the mesh and however slow the graphics. Times are in seconds of any steady clock.
class SnapshotPace {
  public:
    /// True if a waiting snapshot may be drawn. Snapshots of a resting run (`working` false) are always due.
    bool due(double now, bool working) const { return !working || now >= next_; }
    /// Time at which the next one is due.
    double next() const { return next_; }
    /// Notes that a frame that drew a new snapshot ended at `now` and took `cost`.
    void drew(double now, double cost) { next_ = now + std::min(kShare * cost, kLongest); }

  private:
    static constexpr double kShare = 2.0, kLongest = 1.0;
    double next_ = 0.0;
};

} // namespace forefront
