#pragma once

#include <algorithm>

namespace forefront {

/// How often new snapshots of a working run are drawn: so seldom that two thirds of the time are left to what the user
/// does, however large the mesh and however slow the graphics. Times in seconds, of any steady clock.
class SnapshotPace {
  public:
    /// A waiting snapshot may be taken. `working`: the run shown is not at rest; what comes at rest is always due.
    bool due(double now, bool working) const { return !working || now >= next_; }
    /// When the next one is due.
    double next() const { return next_; }
    /// A frame that drew a new snapshot ended at `now` and took `cost`.
    void drew(double now, double cost) { next_ = now + std::min(kShare * cost, kLongest); }

  private:
    static constexpr double kShare = 2.0, kLongest = 1.0;
    double next_ = 0.0;
};

} // namespace forefront
