#pragma once

#include <algorithm>

namespace forefront {

/// Limits how often snapshots of a working run are drawn, so that two thirds of the time remain for user input even
/// with large meshes and slow graphics. Times are in seconds of any steady clock.
class SnapshotPace {
  public:
    /// Returns true if a waiting snapshot may be drawn. Snapshots of an idle run (`working` false) are always due.
    bool due(double now, bool working) const { return !working || now >= next_; }
    /// Returns the time at which the next snapshot is due.
    double next() const { return next_; }
    /// Records that a frame with a new snapshot ended at `now` and took `cost`.
    void recordFrame(double now, double cost) { next_ = now + std::min(kShare * cost, kLongest); }

  private:
    static constexpr double kShare = 2.0, kLongest = 1.0;
    double next_ = 0.0;
};

} // namespace forefront
